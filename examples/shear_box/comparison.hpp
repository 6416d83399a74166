// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "references.hpp"

#include <map>

namespace shear_box {

/// Material coordinates of each particle, in H. The coordinates never change, because the box deforms affinely.
struct MaterialPoints {
  std::vector<double> X, Z;        ///< initial coordinates, with jitter
  std::vector<std::size_t> row;    ///< index of the lattice row, from the bottom
  std::vector<bool> central;       ///< whether in a column closest to mid-width
  std::vector<double> row_height;  ///< z/H of each row
};

/// Returns the material points of particles with lattice positions `cells` and initial positions `placed` (m; the last
/// coordinate is the height).
template <class Vector>
MaterialPoints material_points(Options const& o, std::vector<Vector> const& cells, std::vector<Vector> const& placed) {
  constexpr int up = Vector::RowsAtCompileTime - 1;
  double const H = o.geometry.height, middle = o.geometry.width / 2;
  auto const half_spacings = [&](Vector const& cell) { return std::lround(2 * cell[up] / spacing(o)); };
  MaterialPoints m;
  std::map<long, std::size_t> rows;
  for (auto const& cell : cells) rows.emplace(half_spacings(cell), 0);
  for (auto& [height, number] : rows) {
    number = m.row_height.size();
    m.row_height.push_back(double(height) * spacing(o) / 2 / H);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    m.X.push_back(placed[i][0] / H);
    m.Z.push_back(placed[i][up] / H);
    m.row.push_back(rows.at(half_spacings(cells[i])));
    m.central.push_back(std::abs(cells[i][0] - middle) < 0.75 * spacing(o));
  }
  return m;
}

/// Means over each row of particles.
struct RowMeans {
  std::vector<double> all, centre, lowest, highest, deviation;
};
template <class Values>
RowMeans row_means(MaterialPoints const& m, Values const& value) {
  std::size_t const rows = m.row_height.size();
  RowMeans means{std::vector<double>(rows), std::vector<double>(rows), std::vector<double>(rows, 1e300),
                 std::vector<double>(rows, -1e300), std::vector<double>(rows)};
  std::vector<long> all(rows), centre(rows);
  for (std::size_t i = 0; i < m.row.size(); ++i) {
    std::size_t const row = m.row[i];
    double const v = value(i);
    means.all[row] += v, ++all[row];
    if (m.central[i]) means.centre[row] += v, ++centre[row];
    means.lowest[row] = std::min(means.lowest[row], v);
    means.highest[row] = std::max(means.highest[row], v);
  }
  for (std::size_t row = 0; row < rows; ++row)
    means.all[row] /= double(all[row]), means.centre[row] /= double(centre[row]);
  for (std::size_t i = 0; i < m.row.size(); ++i)
    means.deviation[m.row[i]] += std::pow(value(i) - means.all[m.row[i]], 2) / double(all[m.row[i]]);
  for (double& deviation : means.deviation) deviation = std::sqrt(deviation);
  return means;
}

/// The mean absolute difference (5.3) and the root mean square difference (5.4) of two profiles.
struct Error {
  double mae = 0, rmse = 0;
};
inline Error error(std::vector<double> const& found, std::vector<double> const& expected) {
  Error e;
  for (std::size_t k = 0; k < found.size(); ++k) {
    e.mae += std::abs(found[k] - expected[k]) / double(found.size());
    e.rmse += std::pow(found[k] - expected[k], 2) / double(found.size());
  }
  e.rmse = std::sqrt(e.rmse);
  return e;
}

/// The comparison at one time: the state of the particles, and the references sampled at the particles.
struct Comparison {
  double time = 0;  ///< T
  RowMeans found, best, one_dimensional;
  Error width, centre, width_1d, centre_1d, particles;
  double scatter_width = 0;  ///< largest standard deviation of C within a row
};

inline Comparison compare(MaterialPoints const& m, std::vector<double> const& C, References const& references,
                          std::size_t k) {
  auto const sample = [&](Solution const& solution) {
    std::vector<double> values(C.size());
    for (std::size_t i = 0; i < C.size(); ++i) values[i] = solution(m.X[i], m.Z[i]);
    return values;
  };
  auto const best = sample(references.best[k]), one_dimensional = sample(references.one_dimensional[k]);
  auto const rows = [&](std::vector<double> const& values) {
    return row_means(m, [&](std::size_t i) { return values[i]; });
  };
  Comparison c;
  c.time = references.times[k];
  c.found = rows(C), c.best = rows(best), c.one_dimensional = rows(one_dimensional);
  c.width = error(c.found.all, c.best.all);
  c.centre = error(c.found.centre, c.best.centre);
  c.width_1d = error(c.found.all, c.one_dimensional.all);
  c.centre_1d = error(c.found.centre, c.one_dimensional.centre);
  c.particles = error(C, best);
  c.scatter_width = *std::max_element(c.found.deviation.begin(), c.found.deviation.end());
  return c;
}

}  // namespace shear_box
