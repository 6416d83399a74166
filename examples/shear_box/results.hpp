// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "comparison.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/json.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/wall_clock.hpp>

// The files that a run writes, apart from particles.vtkhdf; see the README in this folder. Times are in T, heights in
// H.
namespace shear_box {

/// Measures of mixing, NaN if C is not finite.
struct Mixing {
  double intensity = 0;  ///< of segregation, 1: separated, 0: mixed
  double lacey = 0;      ///< Lacey's index in cells of four spacings, 0: separated, 1: mixed
};

class Results {
 public:
  Results(app::Run<Options> const& run, MaterialPoints points);

  /// Returns the columns of history.csv.
  static app::Table table(Options const& o);
  /// Sets the table that add_history() writes to.
  void open(scree::CsvSeries history) { history_.emplace(std::move(history)); }
  /// Returns the numbers for a checkpoint; take() restores them.
  std::vector<double> numbers() const;
  void take(std::vector<double> const& all);

  /// Returns the times (T) at which profiles are compared, without times beyond the end of the run.
  std::vector<double> compared_times() const;
  /// Writes a row of history.csv from the concentrations of the particles and the measures of mixing. Throws
  /// std::runtime_error if C is not finite.
  void add_history(double time, std::vector<double> const& C, Mixing const& mixing);
  /// Stores the concentrations for finish().
  void keep_profile(double time, std::vector<double> C);
  /// Writes the profiles and the summary. Unless the run was interrupted, solves the references, writes both again and
  /// prints the comparison.
  void finish(app::Figures const& figures, bool interrupted);

 private:
  void write_profiles(std::vector<Comparison> const& comparisons) const;
  void write_summary(app::Figures const& figures, double wall, References const& references,
                     std::vector<Comparison> const& comparisons) const;
  void print(References const& references, std::vector<Comparison> const& comparisons) const;

  app::Run<Options> run_;
  MaterialPoints points_;
  std::optional<scree::CsvSeries> history_;
  std::vector<double> kept_times_;
  std::vector<std::vector<double>> kept_;
  double start_ = scree::wall_seconds();
  double mean_ = 0, first_mean_ = 0, largest_drift_ = 0, lowest_ = 1e300, highest_ = -1e300;
  Mixing mixing_;
};

}  // namespace shear_box
