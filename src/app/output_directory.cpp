// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/output_directory.hpp>

#include "directory_lock.hpp"

namespace scree::app {

namespace fs = std::filesystem;

namespace {

constexpr char const* checkpoint = "checkpoint.h5";
constexpr char const* previous_checkpoint = "checkpoint.previous.h5";
constexpr char const* end_of_member = "finished.txt";  // of a study

}  // namespace

struct OutputDirectory::State {
  /// Removes a directory that it made, and that nothing was put into.
  struct Made {
    fs::path directory;
    bool is_new = false;

    explicit Made(fs::path path) : directory(std::move(path)) {
      std::error_code error;
      is_new = fs::create_directories(directory, error);
      if (std::error_code other; error && !fs::is_directory(directory, other))
        throw std::runtime_error(
            fmt::format("{}: cannot create the output directory: {}", directory.string(), error.message()));
    }
    Made(Made const&) = delete;
    Made& operator=(Made const&) = delete;
    ~Made() {
      std::error_code not_empty;
      if (is_new) fs::remove(directory, not_empty);
    }
  };

  explicit State(OutputRequest given) : request(std::move(given)), made(request.directory), lock(request.directory) {
    for (auto const* name : {"case.toml", checkpoint, previous_checkpoint, end_of_member})
      request.results.emplace_back(name);
    for (auto const& name : request.results) check(request.directory / name);
  }

  bool continues_in_place() const {
    if (request.continues.empty()) return false;
    auto const beside = request.continues.parent_path();
    std::error_code missing;
    return fs::equivalent(beside.empty() ? "." : beside, request.directory, missing);
  }

  void check(fs::path const& file) const {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error))) return;
    if (fs::is_directory(file, error))
      throw std::runtime_error(fmt::format("{}: is a directory, not a result", file.string()));
    if (!request.force && !continues_in_place())
      throw std::runtime_error(
          fmt::format("{}: holds an earlier result; give another --output, or --force to replace it", file.string()));
  }

  void remove(std::string const& name) const {
    std::error_code error;
    auto const file = request.directory / name;
    fs::remove(file, error);
    if (error) throw std::runtime_error(fmt::format("{}: cannot replace it: {}", file.string(), error.message()));
  }

  /// So that the checkpoints of a directory belong to its tables, and to no later time than these will be cut to.
  void take_over_checkpoint() const {
    auto const file = request.directory / checkpoint, previous = request.directory / previous_checkpoint;
    std::error_code missing;
    if (fs::equivalent(request.continues, file, missing)) return;
    auto part = file;
    part += ".part";
    std::error_code failed;
    fs::copy_file(request.continues, part, fs::copy_options::overwrite_existing, failed);
    if (!failed) fs::rename(part, file, failed);
    if (failed) throw std::runtime_error(fmt::format("{}: cannot write it: {}", file.string(), failed.message()));
    if (!fs::equivalent(request.continues, previous, missing)) remove(previous_checkpoint);
  }

  OutputRequest request;
  Made made;
  DirectoryLock lock;
};

OutputDirectory::OutputDirectory(OutputRequest request) : state_(std::make_unique<State>(std::move(request))) {}
OutputDirectory::~OutputDirectory() = default;

void OutputDirectory::begin(std::string const& case_text) const {
  auto const& request = state_->request;
  std::error_code none;
  if (state_->continues_in_place()) {
    for (auto const& name : request.results) fs::remove(request.directory / (name + ".part"), none);
  } else {
    for (auto const& name : request.results) state_->remove(name + ".part"), state_->remove(name);
  }
  if (!request.continues.empty()) state_->take_over_checkpoint();
  write_file(request.directory / "case.toml", case_text);
}

}  // namespace scree::app
