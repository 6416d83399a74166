// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include "../support/run.hpp"

#include <memory>
#include <string>
#include <vector>

// What a run writes besides particles.vtkhdf, see the README in this folder. Nothing here knows of particles on a
// device.
namespace column_collapse {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profile.csv", "history.csv", "particles.vtkhdf"};
}

/// The deposit at one time.
struct State {
  double time = 0;  ///< s
  long steps = 0;
  int particles = 0;
  std::vector<double> distance = {}, depth = {};  ///< the profile, m
  double reach = 0, summit = 0, speed = 0;        ///< m, m, largest, m/s
};

/// Follows a run and writes its results.
class Recorder {
 public:
  explicit Recorder(support::Run<Options> const& run);
  ~Recorder();
  void record(State const& state);
  /// Writes the summary and prints the run-out beside its band.
  void finish(State const& last, int wall_particles);

 private:
  struct Files;  // keeps what writes files away from compilers for devices
  std::unique_ptr<Files> files_;
};

}  // namespace column_collapse
