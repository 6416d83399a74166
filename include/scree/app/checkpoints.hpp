// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/csv_series.hpp"
#include "../run/checkpoint_policy.hpp"
#include "run.hpp"

#include <functional>
#include <string>
#include <vector>

namespace scree::app {

struct About;  // codec.hpp

/// The option that names the checkpoint to start from, of type std::string and empty by default. `--study` and the
/// message after a signal know it by its name (see Program::restart):
///     .add("restart_from", &Output::restart_from, app::about_restart())
About about_restart();
/// The option with the wall time (s) between two checkpoints, of type double:
///     .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
About about_checkpoints();

/// A table that a run writes row by row.
struct Table {
  std::string file;                ///< in the output directory
  std::vector<CsvColumn> columns;  ///< the first one holds the time
  double unit = 1;                 ///< unit of the times in the table, s
};

/// Checkpoints of a run of a case program in `checkpoint.h5` of its output directory: at intervals of wall time, at a
/// signal and when save() is called at the end. A run that starts from one continues its tables and frames with the
/// bits of a run that was never stopped; they are in the directory of that checkpoint.
///
///     app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
///     checkpoints.keep("mass", [&] { return std::vector{mass}; }, [&](auto const& kept) { mass = kept.at(0); });
///     app::Table const history{"history.csv", {{"time", "s"}, {"mass", "kg"}}};
///     checkpoints.restore(solver, duration, {history});
///     run.begin(solver);
///     auto rows = checkpoints.open(history);
///     auto frames = checkpoints.frames<BodySeries<Fields<Velocity>>>();
///     run_with(solver, duration, observers, progress, checkpoints);
///     checkpoints.save(solver.snapshot());
///     return checkpoints.exit_code();
///
/// Its HDF5 code is in the library scree::app, so that simulations compile faster.
class Checkpoints : public CheckpointPolicy {
 public:
  using Numbers = std::vector<double>;

  /// `interval`: wall time between two checkpoints, s. `from`: the checkpoint to start from; empty: none.
  /// Throws as CheckpointPolicy does.
  template <class T>
  Checkpoints(Run<T> const& run, double interval, std::filesystem::path from = {})
      : Checkpoints(options_of(run.output, run.case_text, interval), std::move(from)) {}
  /// Checkpoints with other options. Tables and frames are in the directory of the file.
  explicit Checkpoints(CheckpointOptions options, std::filesystem::path from = {});
  ~Checkpoints();

  using CheckpointPolicy::keep;
  /// Keeps numbers of the program in each checkpoint, and takes them from the one that restore() reads. Throws
  /// std::logic_error after restore(), which would have left them out.
  void keep(std::string const& name, std::function<Numbers()> numbers, std::function<void(Numbers const&)> take);

  /// Whether the run starts from a checkpoint.
  bool restarts() const { return !from_.empty(); }
  /// Gives the solver the state of the checkpoint to start from, and the program the numbers kept in it; prints how the
  /// case has changed since. Changes nothing if there is no such checkpoint.
  /// Throws std::runtime_error if the checkpoint cannot be read or is not of this case, if the run ends (s) before the
  /// time of the checkpoint, or if one of the tables, or the frames (empty: none), cannot be continued.
  template <class S>
  void restore(S& solver, double end, std::vector<Table> const& tables = {},
               std::string const& frames = "particles.vtkhdf") {
    if (!restarts()) return;
    restored_ = true;
    Snapshot const snapshot = read(from_, print);
    solver.restore(snapshot);
    take(snapshot, end, tables, frames);
  }

  /// The table, with its rows up to the time of the checkpoint that the run starts from. Call it after Run::begin().
  CsvSeries open(Table const& table) const;
  /// Frames in single precision with the notes of the checkpoints, after those up to the time of the checkpoint that
  /// the run starts from. `Series` is a BodySeries. Call it after Run::begin().
  template <class Series>
  Series frames(std::string const& file = "particles.vtkhdf") const {
    if (!restarts())
      return Series(output_ / file, {}, {}, {.single_precision = true, .provenance = {notes_.begin(), notes_.end()}});
    return Series::continued(before() / file, time_, output_ / file,
                             {.single_precision = true, .provenance = {notes_.begin(), notes_.end()}});
  }
  /// The directory of the checkpoint that the run starts from.
  std::filesystem::path before() const { return from_.parent_path(); }

 private:
  static CheckpointOptions options_of(std::filesystem::path const& output, std::string const& case_text,
                                      double interval);
  static void print(std::string const& note);
  void take(Snapshot const& snapshot, double end, std::vector<Table> const& tables, std::string const& frames);

  std::filesystem::path output_, from_;
  Notes notes_;
  std::map<std::string, std::function<void(Numbers const&)>> take_;
  double time_ = 0;  // of the checkpoint, s
  bool restored_ = false;
};

}  // namespace scree::app
