// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../../../examples/shear_box/comparison.hpp"

#include "../../../examples/shear_box/models.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::shear_box_comparison_tests {
namespace {

TEST_CASE("the shear box starts as its references do") {
  shear_box::Options o;
  o.output.reference_spacing = 0.01;
  for (double const spacing : {0.04, 0.025, 0.02, 0.0125, 0.01}) {
    o.numerics.spacing = spacing;
    auto const particles = shear_box::points<2>(o);
    std::vector<double> C;
    for (auto const& cell : particles.cells) C.push_back(shear_box::layered(cell[1], o));
    auto const start = shear_box::compare(shear_box::material_points(o, particles.cells, particles.material), C,
                                          shear_box::solve_references(o, {0.0}), 0);
    INFO("spacing " << spacing << ": " << start.particles.mae << ", " << start.width_1d.mae);
    CHECK(start.particles.mae < 1e-9);
    CHECK(start.width_1d.mae < 1e-9);
  }
}

}  // namespace

}  // namespace scree::test::shear_box_comparison_tests
