// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "material_points.hpp"

#include <scree/app/run.hpp>

#include <map>
#include <memory>

// What a run of the shear box writes besides particles.vtkhdf, see the README in this folder. Nothing here knows of
// particles on a device.
namespace shear_box {

inline std::vector<std::string> result_files() {
  return {"summary.json", "profiles.csv", "history.csv", "particles.vtkhdf"};
}

/// The concentrations at one time.
struct State {
  double time = 0;  ///< T
  long steps = 0;
  std::vector<double> C;
};

/// What a finished run has to say of itself.
struct RunFigures {
  double time = 0;  ///< T
  long steps = 0, neighbour_builds = 0;
  int particles = 0, wall_particles = 0;
  std::map<std::string, long> steps_by_limit;
  std::string execution_space;
};

/// Follows a run and writes its results. Times in T, heights in H.
class Recorder {
 public:
  Recorder(scree::app::Run<Options> const& run, MaterialPoints points);
  ~Recorder();

  /// Times at which profiles are compared, T; those beyond the end of the run are left out.
  std::vector<double> compared_times() const;
  /// Writes a row of history.csv; throws if C is not finite.
  void record_history(State const& state);
  /// Keeps a state for finish().
  void keep_profile(State state);
  /// Solves the references, writes what needs them and prints the comparison.
  void finish(RunFigures const& figures);

 private:
  struct Files;  // keeps what writes files away from compilers for devices
  std::unique_ptr<Files> files_;
};

}  // namespace shear_box
