// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../mesh/triangle.hpp"
#include "../shapes/shape.hpp"
#include "raster.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Heights at the points of a raster and on one more line of points on each side, which continues the heights of the
/// edge outwards over ten times the extent of the raster. A cell is divided into four triangles around its middle,
/// whose height is the mean of those of the corners.
class HeightGrid {
 public:
  explicit HeightGrid(Raster const& raster) : raster_(raster) {
    for (std::size_t k = 0; k < raster.values.size(); ++k)
      if (!(std::abs(raster.values[k]) <= highest)) refuse(k);
    auto const [low, high] = std::minmax_element(raster.values.begin(), raster.values.end());
    low_ = *low, high_ = *high;
    build();
  }

  int cells_x() const { return raster_.columns + 1; }
  int cells_y() const { return raster_.rows + 1; }
  double low() const { return low_; }
  double high() const { return high_; }
  Raster const& raster() const { return raster_; }

  /// Returns the corner of a cell; cells are numbered from -1, the first one outside of the raster.
  Vec<3, double> corner(int i, int j) const {
    int const in_i = std::clamp(i, 0, raster_.columns - 1), in_j = std::clamp(j, 0, raster_.rows - 1);
    double const beyond = 10 * raster_.spacing * std::max(raster_.columns, raster_.rows);
    return {raster_.x_of(in_i) + (i < in_i   ? -beyond
                                  : i > in_i ? beyond
                                             : 0),
            raster_.y_of(in_j) + (j < in_j   ? -beyond
                                  : j > in_j ? beyond
                                             : 0),
            raster_.at(in_i, in_j)};
  }
  std::array<Corners, 4> triangles(int i, int j) const {
    std::array<Vec<3, double>, 4> const c{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
    Vec<3, double> const middle = (c[0] + c[1] + c[2] + c[3]) / 4;
    return {Corners{c[0], c[1], middle}, Corners{c[1], c[2], middle}, Corners{c[2], c[3], middle},
            Corners{c[3], c[0], middle}};
  }
  /// Returns the height of the surface, m.
  double height(double x, double y) const {
    double const u = std::clamp((x - raster_.x) / raster_.spacing, 0.0, double(raster_.columns - 1));
    double const v = std::clamp((y - raster_.y) / raster_.spacing, 0.0, double(raster_.rows - 1));
    int const i = std::min(int(u), raster_.columns - 2), j = std::min(int(v), raster_.rows - 2);
    double const s = u - i - 0.5, t = v - j - 0.5;  // from the middle, in cells
    double const a = raster_.at(i, j), b = raster_.at(i + 1, j), c = raster_.at(i + 1, j + 1), d = raster_.at(i, j + 1);
    double const middle = (a + b + c + d) / 4;
    // The height is linear in each triangle: from the middle to the side, and along the side.
    if (std::abs(s) >= std::abs(t)) {
      double const from = s > 0 ? b : a, to = s > 0 ? c : d;
      return middle + 2 * std::abs(s) * ((from + to) / 2 - middle) + t * (to - from);
    }
    double const from = t > 0 ? d : a, to = t > 0 ? c : b;
    return middle + 2 * std::abs(t) * ((from + to) / 2 - middle) + s * (to - from);
  }

  /// The smallest and the largest height in blocks of 2^level x 2^level cells; at level 0 the blocks are cells.
  struct Level {
    int columns = 0, rows = 0;
    std::vector<std::pair<double, double>> range;
    std::pair<double, double> const& at(int i, int j) const {
      return range[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
    }
  };
  std::vector<Level> const& levels() const { return levels_; }

 private:
  [[noreturn]] void refuse(std::size_t k) const {
    auto const columns = static_cast<std::size_t>(raster_.columns);
    throw std::runtime_error(
        formatted("%s: there is no %s at x = %g, y = %g m (column %zu, row %zu from below): crop "
                  "the raster to a rectangle without gaps",
                  raster_.name.c_str(), std::isnan(raster_.values[k]) ? "value" : "height within 1e5 m",
                  raster_.x_of(int(k % columns)), raster_.y_of(int(k / columns)), k % columns + 1, k / columns + 1));
  }
  void build() {
    Level cells{cells_x(), cells_y(), {}};
    for (int j = -1; j < raster_.rows; ++j)
      for (int i = -1; i < raster_.columns; ++i) {
        std::array<double, 4> const z{corner(i, j)[2], corner(i + 1, j)[2], corner(i + 1, j + 1)[2],
                                      corner(i, j + 1)[2]};
        cells.range.push_back(std::minmax({z[0], z[1], z[2], z[3]}));
      }
    levels_.push_back(std::move(cells));
    while (levels_.back().columns > 1 || levels_.back().rows > 1) levels_.push_back(halved(levels_.back()));
  }
  static Level halved(Level const& fine) {
    Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
    for (int j = 0; j < coarse.rows; ++j)
      for (int i = 0; i < coarse.columns; ++i) {
        auto range = fine.at(2 * i, 2 * j);
        for (int const dj : {0, 1})
          for (int const di : {0, 1}) {
            if (2 * i + di >= fine.columns || 2 * j + dj >= fine.rows) continue;
            auto const& [low, high] = fine.at(2 * i + di, 2 * j + dj);
            range = {std::min(range.first, low), std::max(range.second, high)};
          }
        coarse.range.push_back(range);
      }
    return coarse;
  }

  Raster raster_;
  double low_ = 0, high_ = 0;
  std::vector<Level> levels_;
};

/// The search for the point of the surface that is nearest to x.
class NearestHeight {
 public:
  NearestHeight(HeightGrid const& grid, Vec<3, double> const& x) : grid_(grid), x_(x) {
    point_ = {x[0], x[1], grid.height(x[0], x[1])};
    least_ = sq(point_[2] - x[2]);
    visit(grid.levels().size() - 1, 0, 0);
  }
  Vec<3, double> const& point() const { return point_; }

 private:
  /// Searches a block of cells. Its parts are searched in the order of their distances from x, except those that are
  /// farther away than a known point.
  void visit(std::size_t level, int i, int j) {
    if (level == 0) {
      for (auto const& triangle : grid_.triangles(i - 1, j - 1)) {
        Vec<3, double> const there = nearest_in_triangle(triangle, x_);
        double const squared = (there - x_).squaredNorm();
        if (squared < least_) least_ = squared, point_ = there;
      }
      return;
    }
    struct Part {
      double squared;
      int i, j;
    };
    std::array<Part, 4> parts{};
    std::size_t count = 0;
    auto const& fine = grid_.levels()[level - 1];
    for (int jj = 2 * j; jj < std::min(2 * j + 2, fine.rows); ++jj)
      for (int ii = 2 * i; ii < std::min(2 * i + 2, fine.columns); ++ii)
        parts[count++] = {squared_distance(level - 1, ii, jj), ii, jj};
    auto const nearer = [](Part const& a, Part const& b) { return a.squared < b.squared; };
    for (auto next = parts.begin(), end = parts.begin() + count; next != end; ++next)
      std::rotate(std::upper_bound(parts.begin(), next, *next, nearer), next, next + 1);
    for (std::size_t k = 0; k < count; ++k)
      if (parts[k].squared < least_) visit(level - 1, parts[k].i, parts[k].j);
  }
  double squared_distance(std::size_t level, int i, int j) const {
    int const size = 1 << level;
    auto const low = grid_.corner(i * size - 1, j * size - 1);
    auto const high =
        grid_.corner(std::min((i + 1) * size, grid_.cells_x()) - 1, std::min((j + 1) * size, grid_.cells_y()) - 1);
    auto const [below, above] = grid_.levels()[level].at(i, j);
    double const dx = std::max({low[0] - x_[0], x_[0] - high[0], 0.0}),
                 dy = std::max({low[1] - x_[1], x_[1] - high[1], 0.0});
    return sq(dx) + sq(dy) + sq(std::max({below - x_[2], x_[2] - above, 0.0}));
  }

  HeightGrid const& grid_;
  Vec<3, double> x_, point_;
  double least_ = 0;
};

}  // namespace detail

/// The ground below a surface z = h(x, y), as a shape. In each cell of the raster, the surface consists of four
/// triangles that meet at the centre of the cell, whose height is the mean of the four corner heights. This surface
/// agrees with bilinear interpolation to within a sixteenth of the twist of the cell, |h00 - h10 - h01 + h11|. Beyond
/// the raster, the heights of its edge continue outwards over ten times the extent of the raster. Copies share their
/// data; host only.
class HeightField {
 public:
  static constexpr int dim = 3;
  static constexpr bool costly_distance = true;

  /// Throws std::runtime_error, with the file and the first such place, if the raster has a point without a value or
  /// with a height beyond 1e5 m.
  explicit HeightField(Raster const& raster) : grid_(std::make_shared<detail::HeightGrid const>(raster)) {}

  /// Returns the exact signed distance of x, m.
  double signed_distance(Vec<3, double> const& x) const {
    double const distance = (nearest(x) - x).norm();
    return contains(x) ? -distance : distance;
  }
  bool contains(Vec<3, double> const& x) const { return x[2] < height(x[0], x[1]); }
  /// Returns bounds that are finite only above.
  Box<3> bounds() const {
    Box<3> box = whole_space<3>();
    box.high[2] = grid_->high();
    return box;
  }
  /// Returns the height of the surface, m; beyond the raster, the height at its nearest edge.
  double height(double x, double y) const { return grid_->height(x, y); }
  /// Returns the nearest point of the surface, m.
  Vec<3, double> nearest(Vec<3, double> const& x) const { return detail::NearestHeight(*grid_, x).point(); }
  /// Returns the raster that was given.
  Raster const& raster() const { return grid_->raster(); }
  /// Returns the rectangle of the raster, between its lowest and its highest point, m.
  Box<3> extent() const {
    Raster const& r = raster();
    return {{r.x, r.y, grid_->low()}, {r.x_of(r.columns - 1), r.y_of(r.rows - 1), grid_->high()}};
  }

 private:
  std::shared_ptr<detail::HeightGrid const> grid_;
};

}  // namespace scree
