// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/setup/shapes/shape.hpp>

namespace scree::test::archetypes {

/// A disc of radius 1 m.
struct Disc {
  static constexpr int dim = 2;
  double signed_distance(Vec<2, double> const& x) const { return norm(x) - 1; }
  bool contains(Vec<2, double> const& x) const { return signed_distance(x) < 0; }
  Box<2> bounds() const { return {{-1, -1}, {1, 1}}; }
};
static_assert(Shape<Disc>);

}  // namespace scree::test::archetypes
