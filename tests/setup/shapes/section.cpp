// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/shapes/section.hpp>

#include "samples.hpp"

namespace scree::test::section_tests {

static_assert(Shape<Section<Cylinder>> && !detail::is_costly<Section<Cylinder>>);

TEST_CASE("a section is exact where the body is long, and a lower bound elsewhere") {
  check_distances(
      section(drum, -0.1), [](Vec<2, double> const& x) { return sq(x[0] - 0.2) + sq(x[1] + 0.1) < 0.49; },
      Exact::outside);
  check_distances(
      section(sphere, 0.3), [](Vec<2, double> const& x) { return sq(x[0] - 0.3) + sq(x[1] - 0.2) < 0.48; },
      Exact::nowhere);
  CHECK(section(drum, -0.1).bounds().low.isApprox(Vec<2, double>(-0.5, -0.8)));
}

}  // namespace scree::test::section_tests
