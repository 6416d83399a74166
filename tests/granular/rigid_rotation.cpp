// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/rigid_rotation.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::rigid_rotation_tests {
namespace {

using namespace fields;

template <int Dim>
struct Free : Formulation<Dim> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using integrator = SymplecticEuler;
};
double const dr = 0.1;

/// The rotation of a bar of 6 x 24 (x 6) particles, far from the origin, with velocities that are a function of the
/// offset from its centre.
template <int Dim, class Velocities>
RigidRotation turn_of(Velocities const& of) {
  using X = Vec<Dim, double>;
  X low = X::Constant(7e3), size = X::Constant(6 * dr);
  size[1] = 24 * dr;
  Solver<Free<Dim>> solver({.spacing = dr, .physics = {.gravity = {.magnitude = 0}}},
                           fill_lattice(Box<Dim>{low, low + size}, dr));
  X const centre = low + size / 2;
  solver.set(velocity, [&](X const& x) { return of(X(x - centre)); });
  solver.update_rates();
  return rigid_rotation(solver.whole());
}
template <int Dim>
Mat<Dim, double> spin() {
  Mat<Dim, double> W = Mat<Dim, double>::Zero();
  W(0, 1) = -3, W(1, 0) = 3;
  if (Dim == 3) W(1, Dim - 1) = -4, W(Dim - 1, 1) = 4;
  return W;
}
template <int Dim>
struct In {
  static constexpr int dim = Dim;
};

}  // namespace

TEMPLATE_TEST_CASE("a body that moves and turns is found to turn", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  using X = Vec<dim, double>;
  auto const found = turn_of<dim>([](X const& x) { return X(X::Constant(20) + spin<dim>() * x); });
  CAPTURE(found.rate, found.share, found.strain);
  CHECK(std::abs(found.rate - (dim == 2 ? 3 : 5)) < 1e-9);
  CHECK(std::abs(found.share - 1) < 1e-9);
  CHECK(found.strain < 1e-9);
  CHECK(warning_of_rotation(found, 0.4 / found.rate).empty());
  CHECK(warning_of_rotation(found, 0.6 / found.rate).find("ObjectiveStrain") != std::string::npos);
}
TEMPLATE_TEST_CASE("a body that falls does not turn, and one that is sheared is strained", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  using X = Vec<dim, double>;
  auto const falling = turn_of<dim>([](X const&) { return X(X::Constant(-3)); });
  CAPTURE(falling.rate, falling.share);
  CHECK(warning_of_rotation(falling, 1e3).empty());
  // A tall block: most of the energy of simple shear is that of a rotation about the centre.
  auto const sheared = turn_of<dim>([](X const& x) { return X(2 * x[1] * X::Unit(0)); });
  CAPTURE(sheared.rate, sheared.share, sheared.strain);
  CHECK(sheared.share > 0.9);
  CHECK(std::abs(sheared.strain * sheared.rate - 2) < 1e-9);
  CHECK(warning_of_rotation(sheared, 1e3).empty());
}

}  // namespace scree::test::rigid_rotation_tests
