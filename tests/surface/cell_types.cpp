// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/surface/cell_types.hpp>
#include <scree/surface/detect.hpp>

#include <support/formulations.hpp>
#include <support/set_to.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::cell_types_tests {
using namespace fields;

template <class First, class... Rest>
auto with_all_outermost(std::tuple<First, Rest...> const& passes) {
  return std::apply(
      [](First const&, Rest const&... rest) {
        return std::tuple(point_pass<Material>("all outermost", SetTo<CellType>{1}), rest...);
      },
      passes);
}
/// The surface search without its coarse stage.
struct UmbrellaAlone {
  auto passes(Resolution const& resolution) const { return with_all_outermost(surface_passes(resolution)); }
};
struct CellTypesAlone {
  auto passes(Resolution const&) const { return std::tuple(ClassifyCells{}); }
};

namespace {

template <class P, class Diagnostics>
auto diagnosed(Bed<P::dim> const& bed, double spacing) {
  auto solver = solver_of<Formulated<P, NothingEvolves, AtRest, Diagnostics>>(bed, spacing);
  solver.update_diagnostics();
  return solver;
}

// For particles at their nominal density: the coarse stage does not find a void that fits into a cell.
template <int Dim>
std::vector<Bed<Dim>> beds() {
  Bed<Dim> ball;
  for (auto const& x : fill_lattice(Box<Dim>{Vec<Dim, double>::Constant(-1.5), Vec<Dim, double>::Constant(1.5)}, 0.1))
    if (x.norm() < 1.3) ball.material.push_back(x);
  auto jittered = open_bed<Dim>(Vec<Dim, double>::Ones(), 0.1);
  jitter(jittered.material, 0.02, 9);
  return {open_bed<Dim>(Vec<Dim, double>::Ones(), 0.1), jittered, ball};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the rough stage leaves out no particle that the umbrella would flag", "", Policies) {
  using P = TestType;
  for (auto const& bed : beds<P::dim>()) {
    auto const both = diagnosed<P, SurfaceDetection>(bed, 0.1);
    auto const umbrella = diagnosed<P, UmbrellaAlone>(bed, 0.1);
    auto const found = both.material().to_host(on_surface), expected = umbrella.material().to_host(on_surface);
    int missed = 0, extra = 0, on = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      missed += (expected[i] & surface::free) && !(found[i] & surface::free);
      extra += (found[i] & surface::free) && !(expected[i] & surface::free);
      on += expected[i] != surface::interior;
    }
    CHECK(on > 0);
    CHECK(missed == 0);
    CHECK(extra == 0);
  }
}

TEMPLATE_LIST_TEST_CASE("cell types count cells from the edge of the material", "", Policies) {
  using P = TestType;
  // A block of 15 rows: cells of a support, three rows, start at its lowest particles. Particles are on the edges of
  // cells, so that rounding may shift a row by a cell; at distances 0.1 % less than a spacing it cannot.
  Points<P::dim> points;
  for (auto x : fill_lattice(Box<P::dim>{Vec<P::dim, double>::Zero(), Vec<P::dim, double>::Constant(1.5)}, 0.1))
    points.push_back(0.999 * x);
  auto const solver = diagnosed<P, CellTypesAlone>({points, {}}, 0.1);
  auto const types = solver.material().to_host(cell_type);
  int wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Five cells of three rows along each axis (14 * 0.0999/0.3 = 4.66).
    int to_edge = 5;
    for (int axis = 0; axis < P::dim; ++axis) {
      int const cell = static_cast<int>((points[i][axis] - points[0][axis]) / 0.3 + 1e-6);
      to_edge = std::min({to_edge, cell, 4 - cell});
    }
    wrong += types[i] != 1 + to_edge;
  }
  CHECK(wrong == 0);
}

TEMPLATE_LIST_TEST_CASE("an empty cell inside makes its neighbours outermost", "", DoublePolicies) {
  using P = TestType;
  // Nine cells along each axis, the middle one of which is empty.
  Points<P::dim> points;
  for (auto x : fill_lattice(Box<P::dim>{Vec<P::dim, double>::Zero(), Vec<P::dim, double>::Constant(2.7)}, 0.1)) {
    Vec<P::dim, double> const y = 0.999 * x;
    bool hole = true;
    for (int axis = 0; axis < P::dim; ++axis) {
      int const cell = static_cast<int>((y[axis] - 0.04995) / 0.3 + 1e-6);
      hole = hole && cell == 4;
    }
    if (!hole) points.push_back(y);
  }
  auto const solver = diagnosed<P, CellTypesAlone>({points, {}}, 0.1);
  auto const types = solver.material().to_host(cell_type);
  int wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    int to_edge = 9, to_hole = 0;
    for (int axis = 0; axis < P::dim; ++axis) {
      int const cell = static_cast<int>((points[i][axis] - 0.04995) / 0.3 + 1e-6);
      to_edge = std::min({to_edge, cell, 8 - cell});
      to_hole = std::max(to_hole, std::abs(cell - 4));
    }
    wrong += types[i] != std::min({3, 1 + to_edge, to_hole});
  }
  CHECK(wrong == 0);
}

TEMPLATE_LIST_TEST_CASE("a single particle is outermost", "", DoublePolicies) {
  using P = TestType;
  auto const solver = diagnosed<P, SurfaceDetection>({{Vec<P::dim, double>::Zero()}, {}}, 0.1);
  CHECK(solver.material().to_host(cell_type)[0] == 1);
  CHECK(solver.material().to_host(surface_set)[0] == surface::free);
}

}  // namespace scree::test::cell_types_tests
