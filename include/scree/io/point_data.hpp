// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// Data of particles at one time on the host, for a writer. They depend neither on devices nor on files.
namespace scree {

/// One quantity of n particles: n * components numbers, particle by particle.
struct PointArray {
  std::string name;
  int components = 1;  ///< 1: scalar, 3: vector, 6: symmetric (xx, yy, zz, xy, yz, xz), 9: full tensor (row by row)
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>> values = {};
  std::string unit = {};
};

/// The data of one step of a VtkHdfSeries; see point_data_of().
struct PointData {
  double time = 0;                                                 ///< s
  std::variant<std::vector<double>, std::vector<float>> xyz = {};  ///< 3 n coordinates, m
  std::vector<PointArray> arrays = {};
};

}  // namespace scree
