// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "directory_lock.hpp"
#include "run.hpp"

#include <vector>

namespace support {

struct OutputRequest {
  std::filesystem::path directory;
  std::vector<std::string> results = {};  ///< names of the files the run will write there
  bool force = false;                     ///< results of an earlier run may go
  std::filesystem::path continues = {};   ///< the checkpoint to start from; its results are in the same directory
};

/// The directory that a run writes its results to, and no other run while this lives.
class OutputDirectory {
 public:
  /// Makes sure that a run can write its results, before it starts: creates the directory, and stops when it holds the
  /// results of another run, unless by force or to continue them. Changes no result.
  /// Throws std::runtime_error naming the file and the reason.
  explicit OutputDirectory(OutputRequest request)
      : request_(std::move(request)), made_(request_.directory), lock_(request_.directory) {
    request_.results.emplace_back("case.toml");
    for (auto const* name : {checkpoint, previous_checkpoint}) request_.results.emplace_back(name);
    for (auto const& name : request_.results) check(request_.directory / name);
  }

  /// To be called when nothing but a failing disk can stop the run any more: removes results of another run, so that
  /// none is left; writes case.toml, and a checkpoint to go on from.
  void begin(std::string const& case_text) const {
    std::error_code none;
    if (continues_in_place()) {
      for (auto const& name : request_.results) std::filesystem::remove(request_.directory / (name + ".part"), none);
    } else {
      for (auto const& name : request_.results) remove(name + ".part"), remove(name);
    }
    if (!request_.continues.empty()) take_over_checkpoint();
    scree::write_file(request_.directory / "case.toml", case_text);
  }

 private:
  /// Removes a directory that it made, and that nothing was put into.
  struct Made {
    std::filesystem::path directory;
    bool is_new = false;

    explicit Made(std::filesystem::path path) : directory(std::move(path)) {
      std::error_code error;
      is_new = std::filesystem::create_directories(directory, error);
      if (std::error_code other; error && !std::filesystem::is_directory(directory, other))
        throw std::runtime_error(
            fmt::format("{}: cannot create the output directory: {}", directory.string(), error.message()));
    }
    Made(Made const&) = delete;
    Made& operator=(Made const&) = delete;
    ~Made() {
      std::error_code not_empty;
      if (is_new) std::filesystem::remove(directory, not_empty);
    }
  };

  static constexpr char const* checkpoint = "checkpoint.h5";
  static constexpr char const* previous_checkpoint = "checkpoint.previous.h5";

  bool continues_in_place() const {
    if (request_.continues.empty()) return false;
    auto const beside = request_.continues.parent_path();
    std::error_code missing;
    return std::filesystem::equivalent(beside.empty() ? "." : beside, request_.directory, missing);
  }

  void check(std::filesystem::path const& file) const {
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) return;
    if (std::filesystem::is_directory(file, error))
      throw std::runtime_error(fmt::format("{}: is a directory, not a result", file.string()));
    if (!request_.force && !continues_in_place())
      throw std::runtime_error(
          fmt::format("{}: holds an earlier result; give another --output, or --force to replace it", file.string()));
  }

  void remove(std::string const& name) const {
    std::error_code error;
    auto const file = request_.directory / name;
    std::filesystem::remove(file, error);
    if (error) throw std::runtime_error(fmt::format("{}: cannot replace it: {}", file.string(), error.message()));
  }

  /// So that the checkpoints of a directory belong to its tables, and to no later time than these will be cut to.
  void take_over_checkpoint() const {
    namespace fs = std::filesystem;
    auto const file = request_.directory / checkpoint, previous = request_.directory / previous_checkpoint;
    std::error_code missing;
    if (fs::equivalent(request_.continues, file, missing)) return;
    auto part = file;
    part += ".part";
    std::error_code failed;
    fs::copy_file(request_.continues, part, fs::copy_options::overwrite_existing, failed);
    if (!failed) fs::rename(part, file, failed);
    if (failed) throw std::runtime_error(fmt::format("{}: cannot write it: {}", file.string(), failed.message()));
    if (!fs::equivalent(request_.continues, previous, missing)) remove(previous_checkpoint);
  }

  OutputRequest request_;
  Made made_;
  DirectoryLock lock_;
};

/// Makes the directory of a run ready for its results, see OutputDirectory::begin(); returns the run.
template <class T>
Run<T> const& begin_results(Run<T> const& run) {
  if (run.directory) run.directory->begin(run.case_text);
  return run;
}

}  // namespace support
