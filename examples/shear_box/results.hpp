// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "comparison.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/json.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/wall_clock.hpp>

// The files that a run writes, apart from particles.vtkhdf, see the README in this folder. Times in T, heights in H.
namespace shear_box {

/// Measures of mixing: NaN where C is not finite.
struct Mixing {
  double intensity = 0;  ///< of segregation, 1: apart, 0: mixed
  double lacey = 0;      ///< Lacey's index in cells of four spacings, 0: apart, 1: mixed
};

class Results {
 public:
  Results(app::Run<Options> const& run, MaterialPoints points);

  /// history.csv.
  static app::Table table(Options const& o);
  /// Takes the table that add_history() writes to.
  void open(scree::CsvSeries history) { history_.emplace(std::move(history)); }
  /// Writes the kept numbers to a checkpoint and reads them from one.
  std::vector<double> numbers() const;
  void take(std::vector<double> const& all);

  /// Times at which profiles are compared, T; those beyond the end of the run are left out.
  std::vector<double> compared_times() const;
  /// Writes a row of history.csv from the concentrations of the particles and the measures of mixing; throws if C is
  /// not finite.
  void add_history(double time, std::vector<double> const& C, Mixing const& mixing);
  /// Keeps the concentrations for finish().
  void keep_profile(double time, std::vector<double> C);
  /// Solves the references, unless the run was interrupted, writes what needs them and prints the comparison.
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
