// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

#include "options.hpp"

#include <scree/app/run.hpp>

#include <scree/io/point_data.hpp>

#include <memory>

// What a run of the drum writes, see the README beside this file. Nothing here knows of particles on a device.
namespace drum {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profiles.csv", "radial.csv", "history.csv", "particles.vtkhdf"};
}

/// Where a run begins: at 0, or at the checkpoint that time.restart_from names.
struct Start {
  double time = 0;                  ///< s
  std::vector<double> memory = {};  ///< what Recorder::memory() was then
};

/// Follows a run and writes its results.
class Recorder {
 public:
  /// A run that starts from a checkpoint goes on with the files in the same directory. Throws std::runtime_error, and
  /// leaves all results as they were, when these cannot be read or the run would end before it starts.
  explicit Recorder(scree::app::Run<Options> const& run, Start const& start = {});
  ~Recorder();

  /// Call every output.history_interval: writes a row of history.csv, and the profiles when one of
  /// output.profile_times has been reached. Throws std::runtime_error when a value is not finite.
  void record_history(State const& state);
  /// Call every output.frame_interval.
  void record_frame(scree::PointData const& frame);
  /// Numbers that a recorder needs, with the files, to go on from here.
  std::vector<double> memory() const;
  /// Call at the end, also of a run that was stopped: writes summary.json and prints the main results.
  void finish(RunFigures const& figures);

 private:
  struct Files;  // keeps what writes files away from compilers for devices
  std::unique_ptr<Files> files_;
};

}  // namespace drum
