// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace scree::app {

/// A request for the output directory of a run.
struct OutputRequest {
  std::filesystem::path directory;
  std::vector<std::string> results = {};  ///< names of the files that the run will write there
  bool force = false;                     ///< whether results of an earlier run may be removed
  std::filesystem::path continues = {};   ///< the checkpoint to start from, in the directory of its results
};

/// The directory to which a run writes its results. As long as this object exists, no other run writes there.
class OutputDirectory {
 public:
  /// Creates the directory and checks, before a run starts, that it can write its results. Changes no result. Throws
  /// std::runtime_error with the file and the reason, for instance if the directory contains the results of another run
  /// that are neither to be replaced (`force`) nor continued.
  explicit OutputDirectory(OutputRequest request);
  ~OutputDirectory();

  /// Removes all results of another run and writes case.toml and, if there is one, the checkpoint from which the run
  /// continues. Call this when only a failing disk can still stop the run.
  void begin(std::string const& case_text) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scree::app
