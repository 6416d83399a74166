// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"
#include "state.hpp"

#include <scree/app/figures.hpp>
#include <scree/app/run.hpp>
#include <scree/io/point_data.hpp>

#include <functional>
#include <memory>
#include <vector>

// The files that a run of the drum writes, see the README in this folder.
namespace drum {

namespace app = scree::app;

/// The start of a run: time 0, or the checkpoint that output.restart_from names.
struct Start {
  double time = 0;                  ///< s
  std::vector<double> memory = {};  ///< what Results::memory() was then
};

/// Follows a run and writes its results.
class Results {
 public:
  /// A run that starts from a checkpoint continues the files in the same directory. Throws std::runtime_error, and
  /// leaves all results as they were, when these cannot be read or the run would end before it starts. `begin` is
  /// called when they have been read, and before they are replaced.
  explicit Results(app::Run<Options> const& run, Start const& start = {}, std::function<void()> const& begin = {});
  ~Results();

  /// Call every output.history_interval: writes a row of history.csv, and the profiles when one of
  /// output.profile_times has been reached. Throws std::runtime_error when a value is not finite.
  void add_history(State const& state);
  /// Call every output.frame_interval.
  void add_frame(scree::PointData const& frame);
  /// Numbers that are needed, with the files, to continue from here.
  std::vector<double> memory() const;
  /// Call at the end, also of a run that was stopped: writes summary.json and prints the main results.
  void finish(app::Figures const& figures);

 private:
  struct Files;  // its definition is in results.cpp, so that other sources compile faster
  std::unique_ptr<Files> files_;
};

}  // namespace drum
