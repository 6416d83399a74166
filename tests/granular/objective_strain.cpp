// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/boundaries/plates.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

// Rates of an elastic block of displaced particles with random velocities and stresses, without gravity and viscosity:
// with the objective strain the forces take from the motion what the stress stores, and a rotation has no strain.
namespace scree::test::objective_strain_tests {
namespace {

using namespace fields;

template <class Strain, class Walls>
struct Models : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
  using walls = Walls;
  using strain = Strain;
};
template <int Dim, class Strain, class Walls>
struct Block : Formulation<Dim> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models<Strain, Walls>>;
  using integrator = VelocityVerlet;
};
double const dr = 0.01;
Elastic const law{.young = 1e6, .poisson = 0.3, .rest_density = 1500};

class Random {
 public:
  /// A number from -1 to 1.
  double operator()() { return double(engine_()) / 2147483648.0 - 1; }
  template <int Dim>
  Vec<Dim, double> vector(double size) {
    Vec<Dim, double> x;
    for (int a = 0; a < Dim; ++a) x[a] = size * (*this)();
    return x;
  }

 private:
  std::mt19937 engine_{7};
};

enum class Around { nothing, rough, smooth };

/// 8 particles along each axis, displaced by up to a tenth of the spacing; around them nothing or walls on three sides.
template <int Dim, class Strain, class Walls = ConservingWalls>
auto block(Around around) {
  using B = Block<Dim, Strain, Walls>;
  using X = Vec<Dim, double>;
  Random random;
  X const high = X::Constant((Dim == 3 ? 6 : 8) * dr);
  Box<Dim> const inside{X::Zero(), high}, outside{X::Constant(-3 * dr), high + X::Constant(3 * dr)};
  Box<Dim> open = inside;
  open.high[Dim - 1] += 3 * dr;
  SolverSettings<B> settings{.spacing = dr};
  settings.physics.law = law;
  settings.physics.gravity.magnitude = 0;
  settings.physics.viscosity_speed = 0;
  if constexpr (std::is_same_v<Walls, ConservingWalls>) settings.physics.walls.sliding_speed = 100;  // all at rest
  auto points = fill_lattice(inside, dr);
  for (auto& x : points) x += random.vector<Dim>(0.1 * dr);
  auto const wall = around == Around::nothing ? std::vector<X>() : fill_between(open, outside, dr);
  Solver<B> solver(settings, points, wall);
  solver.set(velocity, [&](X const&) { return random.vector<Dim>(1); });
  solver.set(stress, [&](X const&) { return random.vector<symmetric3_size<Dim>>(1e4); });
  if (around == Around::smooth)
    solver.template set<Wall>(slip_normal, [&](X const& x) {
      int axis = Dim - 1;
      for (int a = 0; a < Dim - 1; ++a)
        if (x[a] < 0 || x[a] > high[a]) axis = a;
      return X(X::Unit(axis));
    });
  return solver;
}

struct Rates {
  double gained = 0, stored = 0, rounding = 0;  ///< power of the forces and of the stress, W; the sum of all parts, W
  double torque = 0, lever = 0;                 ///< of all forces, and the sum of all parts, N m
};
template <int Dim, class S>
Rates rates_of(S const& solver) {
  using X = Vec<Dim, double>;
  auto const V = solver.material().to_host(volume);
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  auto const a = solver.material().to_host(acceleration);
  auto const sigma = solver.material().to_host(stress), rate = solver.material().to_host(stress_rate);
  Rates found;
  double turning = 0;
  Mat<Dim, double> moment = Mat<Dim, double>::Zero();
  for (std::size_t i = 0; i < V.size(); ++i) {
    double const m = law.density() * V[i], power = m * u[i].dot(a[i]);
    Mat<3, double> const s = unpacked(sigma[i]), s_rate = unpacked(rate[i]);
    Mat<3, double> const strain_rate = deviator_of(s_rate) / (2 * law.shear_modulus()) +
                                       s_rate.trace() / (9 * law.bulk_modulus()) * Mat<3, double>::Identity();
    double const stored = V[i] * (s * strain_rate).trace();
    found.gained += power, found.stored += stored, found.rounding += std::abs(power) + std::abs(stored);
    moment += m * a[i] * X(x[i]).transpose();
    turning += m * a[i].norm() * x[i].norm();
  }
  found.torque = (moment - moment.transpose()).norm(), found.lever = turning;
  return found;
}

template <int Dim>
struct In {
  static constexpr int dim = Dim;
};

template <int Dim, class Walls = ConservingWalls>
void check_power(Around around) {
  auto solver = block<Dim, ObjectiveStrain, Walls>(around);
  solver.step(1e-30);  // the forces follow the moments of the evaluation before
  solver.update_rates();
  auto const [gained, stored, rounding, torque, lever] = rates_of<Dim>(solver);
  CAPTURE(Dim, int(around), gained, stored, torque);
  CHECK(std::abs(stored) > 1e-3 * rounding);
  CHECK(std::abs(gained + stored) < 1e-12 * rounding);
  if (around == Around::nothing) CHECK(torque < 1e-12 * lever);
}
/// The largest rate of the stress of a block that turns, without the rotation of the stress, over the modulus and the
/// angular velocity.
template <int Dim, class Strain>
double strained_by_rotation() {
  using X = Vec<Dim, double>;
  auto solver = block<Dim, Strain>(Around::nothing);
  Mat<Dim, double> W = Mat<Dim, double>::Zero();
  W(0, 1) = -3, W(1, 0) = 3;
  if (Dim == 3) W(0, Dim - 1) = 2, W(Dim - 1, 0) = -2;
  solver.set(velocity, [&](X const& x) { return X(W * x); });
  solver.update_rates();
  auto const sigma = solver.material().to_host(stress), rate = solver.material().to_host(stress_rate);
  double largest = 0;
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    Mat<3, double> const s = unpacked(sigma[i]), spin = in_three_dimensions(W);
    Mat<3, double> const rest = Mat<3, double>(unpacked(rate[i])) - (spin * s - s * spin);
    largest = std::max(largest, rest.norm() / (law.young * W.norm()));
  }
  return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("with the objective strain forces do the work of the stress", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  check_power<dim>(Around::nothing);
  check_power<dim>(Around::rough);
  check_power<dim>(Around::smooth);
  check_power<dim, MirrorWalls>(Around::rough);
}
TEMPLATE_TEST_CASE("with the objective strain a block of displaced particles turns without strain", "", In<2>, In<3>) {
  CHECK(strained_by_rotation<TestType::dim, ObjectiveStrain>() < 1e-13);
}
TEMPLATE_TEST_CASE("with the objective strain plates show what mirrors do", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  auto plates = block<dim, ObjectiveStrain, PlateWalls>(Around::rough);
  auto mirrors = block<dim, ObjectiveStrain, MirrorWalls>(Around::rough);
  plates.template set<Wall>(on_plate, [](auto const&) { return 1; });
  plates.step(1e-30), mirrors.step(1e-30);
  plates.update_rates(), mirrors.update_rates();
  auto const a = plates.material().to_host(acceleration), b = mirrors.material().to_host(acceleration);
  auto const turning = plates.material().to_host(antisymmetric_stress);
  CHECK(std::any_of(turning.begin(), turning.end(), [](auto const& each) { return each.norm() > 1; }));
  for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() <= 1e-12 * b[i].norm());
}
TEMPLATE_TEST_CASE("with the objective strain a stress that is set acts in all forces of the next step", "", In<2>,
                   In<3>) {
  auto solver = block<TestType::dim, ObjectiveStrain>(Around::rough);
  solver.step(1);
  solver.set(stress, [](auto const&) { return zero<Vec<symmetric3_size<TestType::dim>, double>>(); });
  for (auto const& a : solver.material().to_host(acceleration)) CHECK(a.norm() == 0);
}
TEMPLATE_TEST_CASE("with the objective strain a run goes on from a snapshot bit for bit", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  auto solver = block<dim, ObjectiveStrain>(Around::rough);
  for (int k = 0; k < 20; ++k) solver.step(1);
  auto other = block<dim, ObjectiveStrain>(Around::rough);
  other.restore(solver.snapshot());
  for (int k = 0; k < 5; ++k) solver.step(1), other.step(1);
  CHECK(solver.material().to_host(stress) == other.material().to_host(stress));
  CHECK(solver.material().to_host(position) == other.material().to_host(position));
}
TEMPLATE_TEST_CASE("control: a symmetric stress alone turns a free block", "", In<2>, In<3>) {
  auto solver = block<TestType::dim, PlainStrain>(Around::nothing);
  solver.update_rates();
  auto const found = rates_of<TestType::dim>(solver);
  CAPTURE(found.torque, found.lever);
  CHECK(std::abs(found.gained + found.stored) < 1e-12 * found.rounding);
  CHECK(found.torque > 1e-4 * found.lever);
}
TEMPLATE_TEST_CASE("control: the plain strain of a block that turns is its spin times the order of its particles", "",
                   In<2>, In<3>) {
  CHECK(strained_by_rotation<TestType::dim, PlainStrain>() > 0.1);
}

}  // namespace scree::test::objective_strain_tests
