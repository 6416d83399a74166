// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

#include "options.hpp"

#include "../support/run.hpp"

#include <memory>

// What a run of the drum writes, see the README beside this file. Nothing here knows of particles on a device.
namespace drum {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profiles.csv", "radial.csv", "history.csv", "particles.vtkhdf"};
}

/// Follows a run and writes its results.
class Recorder {
 public:
  /// `start_time` (s): 0, or the time of the checkpoint that time.restart_from names; then rows up to it are taken over
  /// from the files beside that checkpoint.
  explicit Recorder(support::Run<Options> const& run, double start_time = 0);
  ~Recorder();

  /// Call every output.history_interval: writes a row of history.csv, and the profiles when one of
  /// output.profile_times has been reached. Throws std::runtime_error when a value is not finite.
  void record_history(State const& state);
  /// Call every output.frame_interval.
  void record_frame(Frame const& frame);
  /// Call at the end, also of a run that was stopped: writes summary.json and prints the main results.
  void finish(RunFigures const& figures);

 private:
  struct Files;  // keeps what writes files away from compilers for devices
  std::unique_ptr<Files> files_;
};

}  // namespace drum
