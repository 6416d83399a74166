// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "finite_volume_2d.hpp"

#include <stdexcept>
#include <vector>

namespace shear_box::reference {

namespace detail {

inline double mean_of_block(Field2d const& fine, int column, int row) {
  return 0.25 * (fine.value(2 * column, 2 * row) + fine.value(2 * column + 1, 2 * row) +
                 fine.value(2 * column, 2 * row + 1) + fine.value(2 * column + 1, 2 * row + 1));
}

/// f(-1) - 2 f(0) + f(1); next to a wall extrapolated linearly from the two cells beyond.
template <class Values>
double second_difference(Values const& f, int i, int cells) {
  auto const inner = [&](int k) { return f(k - 1) - 2.0 * f(k) + f(k + 1); };
  if (i == 0) return 2.0 * inner(1) - inner(2);
  if (i == cells - 1) return 2.0 * inner(cells - 2) - inner(cells - 3);
  return inner(i);
}

/// A cell's mean exceeds the value at its centre by h^2/24 laplace C.
inline Field2d centre_values_from_means(Field2d const& means) {
  Field2d centres = means;
  for (int j = 0; j < means.rows; ++j)
    for (int i = 0; i < means.columns; ++i) {
      auto const across = [&](int k) { return means.value(k, j); };
      auto const along = [&](int k) { return means.value(i, k); };
      centres.value(i, j) -=
          (second_difference(across, i, means.columns) + second_difference(along, j, means.rows)) / 24.0;
    }
  return centres;
}

}  // namespace detail

/// Richardson extrapolation of two solutions of a second-order scheme, spacings h and 2h. Both are taken as cell means,
/// so that four fine cells add up to one coarse cell without interpolation; the result, at the fine cells, is the value
/// of C at their centres. It may leave [0, 1] by its own error.
inline Field2d extrapolate(Field2d const& fine, Field2d const& coarse) {
  if (fine.columns != 2 * coarse.columns || fine.rows != 2 * coarse.rows)
    throw std::invalid_argument("shear box reference: extrapolation needs spacings h and 2h");
  Field2d correction = coarse;
  for (int j = 0; j < coarse.rows; ++j)
    for (int i = 0; i < coarse.columns; ++i)
      correction.value(i, j) = (detail::mean_of_block(fine, i, j) - coarse.value(i, j)) / 3.0;

  Field2d means = fine;
  for (int j = 0; j < fine.rows; ++j)
    for (int i = 0; i < fine.columns; ++i) means.value(i, j) += correction(fine.centre(i), fine.centre(j));
  return detail::centre_values_from_means(means);
}

/// Fields at the given times (increasing, in periods), on cells of size `spacing`, extrapolated from solutions of
/// `spacing` and twice `spacing`.
template <class Closure>
std::vector<Field2d> solve_2d_extrapolated(Problem<Closure> const& problem, std::vector<double> const& times,
                                           double spacing = 0.0025) {
  std::vector<Field2d> const coarse = solve_2d(problem, times, 2.0 * spacing);
  std::vector<Field2d> fields = solve_2d(problem, times, spacing);
  for (std::size_t n = 0; n < fields.size(); ++n) fields[n] = extrapolate(fields[n], coarse[n]);
  return fields;
}

}  // namespace shear_box::reference
