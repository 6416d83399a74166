// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/io/vtkhdf.hpp>

#include <support/folder.hpp>

#include <vector>

namespace fs = std::filesystem;
using scree::PointField;
using scree::VtkHdfSeries;

// A step in which every number identifies its place: particle i of step s is at (s, i, 0.5), carries 100 s + i, ...
struct Step {
  double time;
  std::vector<double> xyz, c, normal;
  std::vector<float> speed;
  std::vector<std::int32_t> set;

  Step(int s, int n) : time(0.5 * s) {
    for (int i = 0; i < n; ++i) {
      xyz.insert(xyz.end(), {1.0 * s, 1.0 * i, 0.5});
      c.push_back(100.0 * s + i);
      normal.insert(normal.end(), {1.0 * i, 2.0 * i, 3.0 * s});
      speed.push_back(0.25f * static_cast<float>(i));
      set.push_back(s - i);
    }
  }
  std::vector<PointField> fields() const {
    return {{.name = "C", .values = c},
            {.name = "normal", .components = 3, .values = normal},
            {.name = "speed", .values = speed},
            {.name = "surface set", .values = set}};
  }
  void append_to(VtkHdfSeries& series) const { series.append(time, xyz, fields()); }
};

template <class T>
std::vector<T> joined(std::vector<Step> const& steps, std::vector<T> Step::*member) {
  std::vector<T> all;
  for (auto const& step : steps) all.insert(all.end(), (step.*member).begin(), (step.*member).end());
  return all;
}
