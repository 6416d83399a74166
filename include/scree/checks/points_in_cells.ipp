// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "points_in_cells.hpp"

namespace scree::detail {

SCREE_BODY std::size_t CellNumbers::add(CellIndex const& cell) {
  std::size_t& slot = slots_[place_of(cell)];
  if (slot != 0) return slot - 1;
  cells_.push_back(cell);
  slot = cells_.size();
  if (2 * cells_.size() > slots_.size()) grow();
  return cells_.size() - 1;
}

SCREE_BODY std::size_t CellNumbers::place_of(CellIndex const& cell) const {
  auto const bits = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };
  std::uint64_t const mixed =
      bits(cell[0]) * 0x9E3779B97F4A7C15u ^ bits(cell[1]) * 0xC2B2AE3D27D4EB4Fu ^ bits(cell[2]) * 0x165667B19E3779F9u;
  std::size_t const mask = slots_.size() - 1;
  std::size_t place = static_cast<std::size_t>(mixed ^ mixed >> 29) & mask;
  while (slots_[place] != 0 && !is_same(cells_[slots_[place] - 1], cell)) place = (place + 1) & mask;
  return place;
}

SCREE_BODY void CellNumbers::grow() {
  slots_.assign(2 * slots_.size(), 0);
  for (std::size_t number = 0; number < cells_.size(); ++number) slots_[place_of(cells_[number])] = number + 1;
}

SCREE_BODY double PointsInCells::Hull::squared_distance(Point const& x) const {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double const out = std::max({low[axis] - x[axis], x[axis] - high[axis], 0.0});
    sum += out * out;
  }
  return sum;
}

SCREE_BODY PointsInCells::PointsInCells(std::vector<Point> const& points, std::size_t first, std::size_t last,
                                        double width, CellNumbers const* some)
    : width_(width) {
  std::vector<std::size_t> cell_of_point(last - first, CellNumbers::none);
  std::vector<std::size_t> counts;
  CellIndex before = {};
  std::size_t number = CellNumbers::none;
  for (std::size_t i = first; i < last; ++i) {
    CellIndex const cell = cell_of(points[i], width);
    if (i == first || !is_same(cell, before)) {  // neighbours in memory are often in one cell
      before = cell, number = !some || some->find(cell) != CellNumbers::none ? cells_.add(cell) : CellNumbers::none;
      counts.resize(cells_.size(), 0);
    }
    cell_of_point[i - first] = number;
    if (number != CellNumbers::none) ++counts[number];
  }
  starts_.assign(counts.size() + 1, 0);
  for (std::size_t k = 0; k < counts.size(); ++k) starts_[k + 1] = starts_[k] + counts[k];
  sorted_.resize(starts_.back());
  std::copy(starts_.begin(), starts_.end() - 1, counts.begin());
  for (std::size_t i = first; i < last; ++i)
    if (std::size_t const k = cell_of_point[i - first]; k != CellNumbers::none)
      sorted_[counts[k]++] = {points[i], i}, hull_.add(points[i]);
}

SCREE_BODY CellIndex PointsInCells::cell_of(Point const& x, double width) {
  CellIndex cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double const place = x[axis] / width, far = 1e15;
    auto const whole = static_cast<std::int64_t>(place > -far ? std::min(place, far) : -far);
    cell[axis] = whole - (double(whole) > place ? 1 : 0);
  }
  return cell;
}

SCREE_BODY PointsInCells::Hull PointsInCells::hull_of(std::size_t cell) const {
  Hull hull;
  for (auto const* p = begin(cell); p != end(cell); ++p) hull.add(p->x);
  return hull;
}

SCREE_BODY void PointsInCells::add_near(Hull const& box, double reach, Point const& shift,
                                        std::vector<Numbered>& found) const {
  Point low, high;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::max(box.low[axis] - reach - shift[axis], hull_.low[axis]);
    high[axis] = std::min(box.high[axis] + reach - shift[axis], hull_.high[axis]);
    if (!(low[axis] <= high[axis])) return;
  }
  visit_cells(low, high, width_, [&](CellIndex const& cell) {
    std::size_t const number = cells_.find(cell);
    if (number == CellNumbers::none) return;
    for (auto const* p = begin(number); p != end(number); ++p) {
      Numbered const moved = {{p->x[0] + shift[0], p->x[1] + shift[1], p->x[2] + shift[2]}, p->number};
      if (box.squared_distance(moved.x) < reach * reach) found.push_back(moved);
    }
  });
}

SCREE_BODY CellNumbers PointsInCells::cells_near(double reach) const {
  CellNumbers found;
  for (std::size_t k = 0; k < size(); ++k) {
    Hull const hull = hull_of(k);
    Point low, high;
    for (std::size_t axis = 0; axis < 3; ++axis)
      low[axis] = hull.low[axis] - reach, high[axis] = hull.high[axis] + reach;
    visit_cells(low, high, width_, [&](CellIndex const& cell) { found.add(cell); });
  }
  return found;
}

}  // namespace scree::detail
