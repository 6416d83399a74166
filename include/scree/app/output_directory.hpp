// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace scree::app {

/// The output directory of a run.
struct OutputRequest {
  std::filesystem::path directory;
  std::vector<std::string> results = {};  ///< names of the files the run will write there
  bool force = false;                     ///< results of an earlier run may go
  std::filesystem::path continues = {};   ///< the checkpoint to start from; its results are in the same directory
};

/// The directory that a run writes its results to. While this object exists, no other run writes there.
class OutputDirectory {
 public:
  /// Makes sure that a run can write its results, before it starts: creates the directory, and stops when it holds the
  /// results of another run, unless by force or to continue them. Changes no result.
  /// Throws std::runtime_error naming the file and the reason.
  explicit OutputDirectory(OutputRequest request);
  ~OutputDirectory();

  /// Removes all results of another run. Writes case.toml, and the checkpoint that the run continues, if there is one.
  /// Call it when only a failing disk can still stop the run.
  void begin(std::string const& case_text) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scree::app
