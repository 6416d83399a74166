// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/formulations.hpp>
#include <support/policies.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::unset_fields_tests {
using namespace fields;

struct Charge : Scalar<"charge", "C"> {};
inline constexpr Charge charge{};

namespace {

using Catch::Matchers::ContainsSubstring;

/// Reads fields of material and walls that a user might forget to set.
struct Pressing {
  using reads = Fields<Volume, Mass, Density, Velocity, Stress>;
  using reads_i = Fields<Charge>;
  using adds = Fields<Acceleration, DensityRate>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    sum[acceleration] += j[mass] / j[density] * i[charge] * ij.gradW();
    sum[density_rate] += 0 * j[mass];
  }
};
struct Fluid {
  using evolves = Fields<Position, Velocity, Density>;
  auto passes(Resolution const&) const {
    return std::tuple(pair_pass<Material>("press", over<Material>(Pressing{}), over<Wall>(Pressing{})));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("step", 1e-3)); }
};
using S = Solver<Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Fluid>>;

S fluid(bool with_wall) {
  auto bed = layer({1, 0.5}, 0.1);
  if (!with_wall) bed.wall.clear();
  return solver_of<S::policy>(bed, 0.1);
}
template <class Body, Field F>
void give(S& solver, F field, double value) {
  solver.set<Body>(field, [=](auto const&) { return value; });
}
std::string complaint(S& solver) {
  try {
    solver.step(1);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("fields that passes read and nobody gave are refused by name, one after the other") {
  auto solver = fluid(true);
  CHECK_THAT(complaint(solver), ContainsSubstring("scree: mass (kg) of the material is read by passes"));
  give<Material>(solver, mass, 1);
  // The density evolves, but not from zero.
  CHECK_THAT(complaint(solver), ContainsSubstring("scree: density (kg/m^3) of the material"));
  give<Material>(solver, density, 1000);
  CHECK_THAT(complaint(solver), ContainsSubstring("scree: charge (C) of the material"));
  give<Material>(solver, charge, 0);  // zeros that are meant
  CHECK_THAT(complaint(solver), ContainsSubstring("scree: mass (kg) of the wall"));
  give<Wall>(solver, mass, 1);
  CHECK_THAT(complaint(solver), ContainsSubstring("scree: density (kg/m^3) of the wall"));
  give<Wall>(solver, density, 1000);
  CHECK(complaint(solver) == "");  // velocity and stress may be zero
  CHECK(solver.steps() == 1);
}

TEST_CASE("fields of a body without particles need not be given") {
  auto solver = fluid(false);
  give<Material>(solver, mass, 1);
  give<Material>(solver, density, 1000);
  give<Material>(solver, charge, 1);
  CHECK(complaint(solver) == "");
}

TEST_CASE("a field that was written to by hand counts as given") {
  auto solver = fluid(false);
  give<Material>(solver, density, 1000);
  give<Material>(solver, charge, 1);
  copy_into(solver.material()[mass].part(0, solver.material().size()),
            std::vector<double>(std::size_t(solver.material().size()), 2));
  CHECK(complaint(solver) == "");
}

TEST_CASE("a restored solver has what it needs") {
  auto solver = fluid(false), other = fluid(false);
  give<Material>(solver, mass, 1);
  give<Material>(solver, density, 1000);
  give<Material>(solver, charge, 0);
  solver.step(1);
  other.restore(solver.snapshot());
  CHECK(complaint(other) == "");
}

}  // namespace scree::test::unset_fields_tests
