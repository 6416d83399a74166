// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R21: layers on a slope below yield, with all models by default, from the exact stress. R24: floors under such a layer
// that move by a motion whose functions contradict each other.
#include "tally.hpp"

#include <scree/granular/granular.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree::test::layers_tests {
using namespace fields;
namespace {

double const spacing = 0.01, g = 9.81, density = 1500, poisson = 0.3, K0 = 0.75;  // m, m/s^2, kg/m^3, -, -

/// A motion along the first axis as a user writes it, x = A (sin(omega t + phi) - sin(phi)) and a jump. The velocity
/// and acceleration that it returns are multiplied by factors; the correct ones are 1. By default it is at rest.
struct Told {
  double amplitude = 0, omega = 0, phase = 0;  // m, rad/s, rad
  double velocity_factor = 1, acceleration_factor = 1, jump = 0, jumps_at = 0;
  SCREE_FN double way(double t) const { return amplitude * Kokkos::sin(omega * t + phase) + (t > jumps_at ? jump : 0); }
  template <class X>
  SCREE_FN static X along(double value) {
    X x = zero<X>();
    x[0] = typename X::Scalar(value);
    return x;
  }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + along<X>(way(to) - way(from));
  }
  template <class X>
  SCREE_FN X velocity(X const&, double t) const {
    return along<X>(velocity_factor * amplitude * omega * Kokkos::cos(omega * t + phase));
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double t) const {
    return along<X>(-acceleration_factor * amplitude * sq(omega) * Kokkos::sin(omega * t + phase));
  }
  double time_step() const { return Kokkos::Experimental::infinity_v<double>; }
};

template <int Dim>
struct Sand : Formulation<Dim> {
  using physics = Granular<>;
  using motion = Told;
};

struct Layer {
  int rows;
  double share;      // of the yield stress that the layer bears, -
  double stiffness;  // speed of compression waves over sqrt(g depth), -

  double depth() const { return rows * spacing; }
  double sound_speed() const { return stiffness * std::sqrt(g * depth()); }
  double fall() const { return std::sqrt(depth() / g); }  // s
  std::string text() const {
    return std::to_string(rows) + " rows, " + std::to_string(share) + " of yield, c = " + std::to_string(stiffness) +
           " sqrt(g H)";
  }
};

template <int Dim>
auto solver_of(Layer const& layer, Told const& motion = {}) {
  using X = Vec<Dim, double>;
  int const up = Dim - 1;
  double const length = 10 * spacing, width = 7 * spacing, height = layer.depth();
  X low = X::Zero(), high = X::Constant(width);
  high[0] = length, high[up] = height;
  auto const bed = fill_lattice(Box<Dim>{low, high}, spacing);
  low[up] = -4 * spacing, high[up] = 0;
  auto const floor = fill_lattice(Box<Dim>{low, high}, spacing);
  std::vector<Period> periods{{0, 0, length}};
  if (Dim == 3) periods.push_back({1, 0, width});

  Granular<> physics;
  double const modulus = density * sq(layer.sound_speed());  // K + 4G/3
  physics.law.elastic = {modulus * (1 + poisson) * (1 - 2 * poisson) / (1 - poisson), poisson, density};
  physics.law.grains = {0.5e-3};
  double const angle = std::atan(layer.share * friction_ratio(physics.law.mu_s));
  physics.gravity = {g, angle};
  Solver<Sand<Dim>> solver({.spacing = spacing, .physics = physics, .motion = motion, .periods = periods}, bed, floor);
  solver.set(stress, [=](X const& x) {
    double const p = density * g * (height - x[up]);
    Mat<3, double> sigma = -K0 * p * std::cos(angle) * Mat<3, double>::Identity();
    sigma(up, up) = -p * std::cos(angle);
    sigma(0, up) = sigma(up, 0) = p * std::sin(angle);
    return packed<Dim>(sigma);
  });
  return solver;
}

/// How a layer moves that does not come to rest within a time (s), or "".
template <int Dim>
std::string fault_of_rest(Layer const& layer, double duration, double& worst) {
  auto solver = solver_of<Dim>(layer);
  int const samples = 40;
  double early = 0, late = 0, way = 0, middle = 0;  // m/s, m/s, m, m
  double const length = 10 * spacing;
  auto before = solver.material().to_host(position);
  for (int k = 1; k <= samples; ++k) {
    solver.run(k * duration / samples);
    auto const x = solver.material().to_host(position);
    auto const u = solver.material().to_host(velocity);
    double speed = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      double const by = x[i][0] - before[i][0];
      way += (by - length * std::round(by / length)) / double(x.size());
      speed += u[i].squaredNorm() / double(x.size());
    }
    before = x;
    if (k == samples / 2) middle = way;
    double& most = k > 3 * samples / 4 ? late : early;
    if (k > samples / 4 && (k <= samples / 2 || k > 3 * samples / 4)) most = std::max(most, std::sqrt(speed));
  }
  double const later = std::abs(way - middle) / spacing;
  worst = std::max(worst, later);
  std::string const figures = std::to_string(1e3 * early) + " mm/s, later " + std::to_string(1e3 * late) +
                              " mm/s; way " + std::to_string(middle / spacing) + " spacings, then " +
                              std::to_string((way - middle) / spacing);
  if (!(later < 0.01)) return layer.text() + " creeps: " + figures;
  // Elastic waves are damped slowly, and a maximum of samples of them scatters.
  if (!(late < 1.05 * early || late < 1e-4 * layer.sound_speed())) return layer.text() + " speeds up: " + figures;
  return "";
}

template <int Dim>
void attempt_rest(int number, int most_rows, double falls) {
  Tally tally("R21");
  auto generator = random_of(210 + Dim);
  double worst = 0;
  for (int k = 0; k < number; ++k) {
    Layer const layer{6 + random_below(generator, most_rows - 5), random_between(generator, 0.6, 0.9),
                      random_between(generator, 15, 30)};
    tally.count(fault_of_rest<Dim>(layer, falls * layer.fall(), worst));
  }
  char note[120];
  std::snprintf(note, sizeof note, "%dD, 6 to %d rows, second half: at most %.4f spacings", Dim, most_rows, worst);
  tally.note(note);
}

/// The message of a run of some steps over a floor with a motion; "" without one.
std::string complaint(Told const& motion, long steps) {
  auto solver = solver_of<2>({.rows = 6, .share = 0.6, .stiffness = 20}, motion);
  try {
    while (solver.steps() < steps) solver.step(1);
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("layers on a slope below yield come to rest, whatever their rows, angle and stiffness", "[R21]") {
  attempt_rest<2>(attempts(2, 60), attempts(8, 20), attempts(8, 20));
  attempt_rest<3>(attempts(1, 8), attempts(6, 10), attempts(2, 10));
}

// Accelerations are wrong by 5e-4 m/s^2 or more: what is below a tenth of it is lost in the rounding of velocities.
TEST_CASE("motions that contradict themselves are refused, and others are not", "[R24]") {
  Tally tally("R24");
  tally.note("motions of a floor, one in four tells the truth");
  auto generator = random_of(241);
  for (int k = 0; k < attempts(8, 100); ++k) {
    Told motion{.amplitude = random_between(generator, 3e-4, 1e-3),
                .omega = random_between(generator, 15, 30),
                .phase = random_between(generator, 0.3, 1.2)};
    double const wrong = (random_below(generator, 2) == 0 ? -1 : 1) * std::pow(10, random_between(generator, -1.6, 1));
    long steps = 30;
    switch (k % 4) {
      case 1:  // velocity and acceleration agree with each other
        motion.velocity_factor += wrong, motion.acceleration_factor += wrong;
        break;
      case 2:
        motion.acceleration_factor += wrong;
        break;
      case 3:
        motion.jump = spacing * std::pow(10, random_between(generator, -1, 2));
        motion.jumps_at = random_between(generator, 0, 2e-3), steps = 3000;
        break;
      default:
        break;
    }
    std::string const said = complaint(motion, steps);
    bool const is_refused = said.find("the motion contradicts itself") != std::string::npos;
    std::string const what =
        "amplitude " + std::to_string(motion.amplitude) + " m, omega " + std::to_string(motion.omega) +
        " rad/s, velocity x " + std::to_string(motion.velocity_factor) + ", acceleration x " +
        std::to_string(motion.acceleration_factor) + ", jump " + std::to_string(motion.jump) + " m";
    tally.count((k % 4 == 0 ? said.empty() : is_refused) ? "" : what + ": " + (said.empty() ? "goes on" : said));
  }
}

}  // namespace scree::test::layers_tests
