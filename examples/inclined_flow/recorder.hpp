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
namespace inclined_flow {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profile.csv", "history.csv", "particles.vtkhdf"};
}

/// The layer at one time.
struct State {
  double time = 0;  ///< s
  long steps = 0;
  int particles = 0;
  /// Means over slices as thick as a row: height in H, velocity, that of the exact flow (m/s), pressure in the exact
  /// one.
  std::vector<double> height = {}, mean_velocity = {}, exact_velocity = {}, pressure_ratio = {};
  double deviation = 0;  ///< from the exact velocity, largest between 0.2 H and 0.8 H
  double ratio = 0;      ///< mean velocity in that of the exact flow
};
struct Figures {
  double settling_time = 0, granular_viscosity = 0, artificial_viscosity = 0;  ///< s, m^2/s
  int wall_particles = 0;
};

/// Follows a run and writes its results.
class Recorder {
 public:
  Recorder(support::Run<Options> const& run, Figures const& figures);
  ~Recorder();
  void record(State const& state);
  void finish(State const& last);

 private:
  struct Files;  // keeps what writes files away from compilers for devices
  std::unique_ptr<Files> files_;
};

}  // namespace inclined_flow
