// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "finite_volume_1d.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

// A solver for the oscillating box in two dimensions. In material coordinates X = x - z gamma(t), Z = z, the box is a
// fixed rectangle and its affine motion vanishes. With C_x = C_X and C_z = C_Z - gamma C_X, the fluxes j = (-D C_x, -V
// F - D C_z) become J_X = j_x - gamma j_z, J_Z = j_z (Piola):
//   J_X = gamma V F - D (1 + gamma^2) C_X + gamma D C_Z
//   J_Z = -V F - D (C_Z - gamma C_X),            no flux through the four sides.
// Together J = -K (D grad C + V F e_Z) with K = [1 + gamma^2, -gamma; -gamma, 1], and for |gamma| < 1
//   K = (1 + gamma^2 - |gamma|) e_X e_X + (1 - |gamma|) e_Z e_Z + |gamma| d d,   d = (sign gamma, -1):
// a sum, with positive weights, of fluxes along edges between cells (horizontal, vertical and one diagonal). Each edge
// that descends carries the one-dimensional flux. Hence the scheme is conservative, keeps C in [0, 1] under the
// one-dimensional condition on the cell Peclet number, and has the one-dimensional steady state.
//
// Diagonals end half a cell before a wall. The flux along the wall in this half layer follows from the no-flux
// condition, not from a one-sided derivative, which would reduce the scheme to first order:
//   bottom and top  J_Z = 0:  J_X = -D C_X;        sides  J_X = 0:  J_Z = -(D C_Z + V F)/(1 + gamma^2).
namespace shear_box::reference {

namespace detail {

template <class Closure>
class ShearedBox {
 public:
  ShearedBox(Problem<Closure> const& problem, double h)
      : edge_{problem, h},
        columns_(cells_across(problem.width, h)),
        rows_(cells_across(1.0, h)),
        percolation_(static_cast<std::size_t>(columns_) * rows_),
        across_(columns_ + 1, 0.0),
        down_(columns_),
        down_next_(columns_),
        diagonal_(columns_ + 1, 0.0),
        diagonal_next_(columns_ + 1, 0.0) {
    if (std::abs(problem.shear_amplitude) >= 1.0)
      throw std::invalid_argument("shear box reference: the 2D scheme needs a shear amplitude below 1");
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  // Makes a forward Euler step. Time is the clock of the closure, see SegregationClosure.
  void euler(double const* C, double* result, double clock, double dt) {
    Problem<Closure> const problem = edge_.problem;  // a copy, which stores to arrays of double cannot alias
    Weights const weights(problem.shear(problem.closure.time(clock)));
    for (std::size_t i = 0; i < percolation_.size(); ++i) percolation_[i] = problem.percolation(C[i]);

    std::fill(down_.begin(), down_.end(), 0.0);
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    for (int row = 0; row < rows_; ++row) {
      flow_across(C, row, weights);
      flow_down(C, row, weights);
      update_row(C, result, row, {.scale = dt / edge_.h, .leaning_right = weights.leaning_right});
      std::swap(down_, down_next_);
      std::swap(diagonal_, diagonal_next_);
    }
  }

  // Returns the step h^2/(4 D). In a step dt a cell gives at most the fraction 2 (2 + gamma^2 - |gamma|) D dt/h^2 <= 4
  // D dt/h^2 of its content to its neighbours. Short vertical waves, which the initial jump contains, are damped well,
  // because they involve only half of these edges.
  double euler_limit() const { return edge_.h * edge_.h / (4.0 * edge_.largest_diffusivity()); }

 private:
  // Weights of the fluxes along edges. wall_across and wall_down are for cells next to a wall.
  struct Weights {
    explicit Weights(double gamma)
        : diagonal(std::abs(gamma)),
          across(1.0 + gamma * gamma - diagonal),
          wall_across(0.5 * across + 0.5),
          down(1.0 - diagonal),
          wall_down(0.5 * down + 0.5 / (1.0 + gamma * gamma)),
          leaning_right(gamma > 0.0) {}
    double diagonal, across, wall_across, down, wall_down;
    bool leaning_right;
  };

  struct Update {
    double scale;
    bool leaning_right;
  };

  void flow_across(double const* C, int row, Weights weights) {
    double const* c = C + static_cast<std::size_t>(row) * columns_;
    double const weight = row == 0 || row == rows_ - 1 ? weights.wall_across : weights.across;
    EdgeFlux<Closure> const edge = edge_;
    for (int i = 1; i < columns_; ++i) across_[i] = weight * edge.sideways(c[i - 1], c[i]);
  }

  // Computes the fluxes from the row above: down_next_ for each cell, and diagonal_next_ for the vertex to the left of
  // each cell.
  void flow_down(double const* C, int row, Weights weights) {
    if (row == rows_ - 1) {
      std::fill(down_next_.begin(), down_next_.end(), 0.0);
      std::fill(diagonal_next_.begin(), diagonal_next_.end(), 0.0);
      return;
    }
    EdgeFlux<Closure> const edge = edge_;
    std::size_t const start = static_cast<std::size_t>(row) * columns_;
    double const* low = C + start;
    double const* up = low + columns_;
    double const* low_flow = percolation_.data() + start;
    double const* up_flow = low_flow + columns_;
    for (int i = 0; i < columns_; ++i)
      down_next_[i] = weights.down * edge.downwards({up[i], up_flow[i]}, {low[i], low_flow[i]});
    for (int i : {0, columns_ - 1})
      down_next_[i] = weights.wall_down * edge.downwards({up[i], up_flow[i]}, {low[i], low_flow[i]});
    int const from = weights.leaning_right ? -1 : 0;  // d = (1, -1) leaves the upper left cell of a vertex
    int const to = -1 - from;
    for (int i = 1; i < columns_; ++i)
      diagonal_next_[i] =
          weights.diagonal * edge.downwards({up[i + from], up_flow[i + from]}, {low[i + to], low_flow[i + to]});
  }

  void update_row(double const* C, double* result, int row, Update update) const {
    std::size_t const start = static_cast<std::size_t>(row) * columns_;
    int const out = update.leaning_right ? 1 : 0;  // vertex through which the downward diagonal leaves the cell
    int const in = 1 - out;
    for (int i = 0; i < columns_; ++i) {
      double const upright = down_next_[i] - down_[i];
      double const diagonal = diagonal_next_[i + in] - diagonal_[i + out];
      result[start + i] = C[start + i] + update.scale * (across_[i] - across_[i + 1] + upright + diagonal);
    }
  }

  EdgeFlux<Closure> edge_;
  int columns_, rows_;
  std::vector<double> percolation_;
  std::vector<double> across_;                    // rightwards through the left faces of a row
  std::vector<double> down_, down_next_;          // downwards through the lower and upper faces of a row
  std::vector<double> diagonal_, diagonal_next_;  // through the lower and upper vertices of a row; zero on walls
};

}  // namespace detail

/// Returns the fields at the given times (increasing, in periods), with an error of second order in the spacing.
template <class Closure>
std::vector<Field2d> solve_2d(Problem<Closure> const& problem, std::vector<double> const& times,
                              double spacing = 0.0025) {
  require_increasing(times);
  detail::ShearedBox<Closure> box(problem, spacing);
  Field2d field{.h = spacing, .columns = box.columns(), .rows = box.rows(), .values = {}};
  for (int j = 0; j < field.rows; ++j)
    field.values.insert(field.values.end(), field.columns, initial_mean(j * spacing, (j + 1) * spacing));

  SspRungeKutta<detail::ShearedBox<Closure>> time_integrator(
      box, {.euler_limit = box.euler_limit(), .longest = 4.0 * spacing}, field.values.size());
  std::vector<Field2d> fields;
  double now = 0.0;
  for (double time : times) {
    double const target = problem.closure.clock(time);
    while (now < target) {
      // Steps end at quarter periods, because |gamma| (or gamma as a function of the clock of (5.5)) has kinks there.
      double const next = std::min(target, 0.25 * (std::floor(4.0 * now + 1e-9) + 1.0));
      time_integrator.advance(field.values, now, next);
      now = next;
    }
    fields.push_back(field);
  }
  return fields;
}

namespace detail {

inline double mean_of_block(Field2d const& fine, int column, int row) {
  return 0.25 * (fine.value(2 * column, 2 * row) + fine.value(2 * column + 1, 2 * row) +
                 fine.value(2 * column, 2 * row + 1) + fine.value(2 * column + 1, 2 * row + 1));
}

/// Returns f(i - 1) - 2 f(i) + f(i + 1); next to a wall, linearly extrapolated from this difference at the next two
/// cells.
template <class Values>
double second_difference(Values const& f, int i, int cells) {
  auto const inner = [&](int k) { return f(k - 1) - 2.0 * f(k) + f(k + 1); };
  if (i == 0) return 2.0 * inner(1) - inner(2);
  if (i == cells - 1) return 2.0 * inner(cells - 2) - inner(cells - 3);
  return inner(i);
}

/// Returns the values at cell centres, given the means over cells. The mean over a cell exceeds the value at its centre
/// by h^2/24 times the Laplacian of C.
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

/// Returns the Richardson extrapolation of two solutions of a second-order scheme with spacings h and 2h. Both
/// solutions are taken as cell means, so that the mean of four fine cells corresponds to one coarse cell without
/// interpolation. The result is the value of C at the centres of the fine cells, and may leave [0, 1] by its own error.
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

/// Returns the fields at the given times (increasing, in periods) on cells of size `spacing`, extrapolated from
/// solutions with `spacing` and twice `spacing`.
template <class Closure>
std::vector<Field2d> solve_2d_extrapolated(Problem<Closure> const& problem, std::vector<double> const& times,
                                           double spacing = 0.0025) {
  std::vector<Field2d> const coarse = solve_2d(problem, times, 2.0 * spacing);
  std::vector<Field2d> fields = solve_2d(problem, times, spacing);
  for (std::size_t n = 0; n < fields.size(); ++n) fields[n] = extrapolate(fields[n], coarse[n]);
  return fields;
}

}  // namespace shear_box::reference
