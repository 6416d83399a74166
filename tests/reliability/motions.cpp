// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R24: tables of motions and motions that are composed of others.
#include "tally.hpp"

#include <scree/motion/composed.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/motion/translation.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scree::test::motions_tests {
namespace {
using X = Vec<3, double>;

X random_point(std::mt19937& generator, double reach) {
  X x;
  for (int axis = 0; axis < 3; ++axis) x[axis] = random_between(generator, -reach, reach);
  return x;
}
RotationAbout random_rotation(std::mt19937& generator) {
  return {random_between(generator, -10, 10), random_point(generator, 1) + X(0, 0, 1.5), random_point(generator, 0.5)};
}
Oscillation<3> random_oscillation(std::mt19937& generator) {
  return {.amplitude = random_point(generator, 0.3), .period = random_between(generator, 1, 5)};
}
/// A random path with points at multiples of 0.1 s.
Tabulated<3> random_path(std::mt19937& generator) {
  std::vector<double> times;
  std::vector<X> places;
  for (int k = 0; k < 11; ++k) times.push_back(0.1 * k), places.push_back(random_point(generator, 0.1));
  return {times, places};
}

/// Whether the way between two near times is that of the velocity and the change of the velocity that of the
/// acceleration, by Simpson's rule, which is exact for the pieces of a table; and whether the way back leads to the
/// start.
template <class Motion>
std::string fault_of_path(Motion const& motion, X const& at_rest, double from, double to) {
  auto const place = [&](double t) { return X(motion.displaced(at_rest, 0.0, t)); };
  double const length = to - from, middle = (from + to) / 2;
  X const a = place(from), m = place(middle), b = place(to);
  X const u[] = {motion.velocity(a, from), motion.velocity(m, middle), motion.velocity(b, to)};
  X const change[] = {motion.acceleration(a, from), motion.acceleration(m, middle), motion.acceleration(b, to)};
  double const speed = std::max({u[0].norm(), u[1].norm(), u[2].norm()});
  double const most = std::max({change[0].norm(), change[1].norm(), change[2].norm()});
  auto const simpson = [&](X const(&v)[3]) { return X(length / 6 * (v[0] + 4 * v[1] + v[2])); };
  double const rounding = 1e-13 * (1 + a.norm() + speed + most);
  if (!((b - a - simpson(u)).norm() < 1e-6 * speed * length + rounding)) return "velocity and way differ";
  if (!((u[2] - u[0] - simpson(change)).norm() < 1e-6 * most * length + rounding))
    return "acceleration and velocity differ";
  if (!((X(motion.displaced(b, to, from)) - a).norm() < 1e-12 * (1 + a.norm()))) return "the way back leads elsewhere";
  return "";
}

/// The fault of a table of a motion, or "".
std::string fault_of_table(std::vector<double> const& times, std::vector<X> const& places, TableInterpolation kind,
                           std::mt19937& generator) {
  Tabulated<3> const motion(times, places, kind);
  X const at_rest = random_point(generator, 1);
  double largest = 1;
  for (X const& x : places) largest = std::max(largest, x.norm());
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    X const low = places[k].cwiseMin(places[k + 1]), high = places[k].cwiseMax(places[k + 1]);
    auto const at = [&](double s) { return times[k] + s * (times[k + 1] - times[k]); };
    for (int n = 0; n < 20; ++n) {
      double const t = at(random_between(generator, 0, 1));
      X const x = places[0] + motion.displaced(X(X::Zero()), times[0], t);
      double const beyond = std::max((low - x).maxCoeff(), (x - high).maxCoeff());
      if (beyond > 1e-13 * largest) return "leaves the range of its points by " + std::to_string(beyond) + " m";
      for (int axis = 0; axis < 3; ++axis)
        if (low[axis] == high[axis] && motion.velocity(x, t)[axis] != 0) return "moves where its table holds";
    }
    if ((motion.displaced(X(X::Zero()), times[0], times[k + 1]) - (places[k + 1] - places[0])).norm() > 1e-13 * largest)
      return "misses a point";
    double const from = random_between(generator, 0.01, 0.5), to = random_between(generator, 0.5, 0.99);
    if (auto const fault = fault_of_path(motion, at_rest, at(from), at(to)); !fault.empty()) return fault;
  }
  return "";
}

}  // namespace

TEST_CASE("random tables of a motion pass their points, stay between them and are consistent", "[R24]") {
  Tally tally("R24");
  tally.note("tables, monotone and linear");
  auto generator = random_of(242);
  for (int k = 0; k < attempts(50, 2000); ++k) {
    std::vector<double> times{random_between(generator, -1, 1)};
    std::vector<X> places{random_point(generator, 1)};
    for (int more = 1 + random_below(generator, 31); more > 0; --more) {
      times.push_back(times.back() + std::pow(10, random_between(generator, -2, 2)));
      X step = std::pow(10, random_between(generator, -3, 3)) * random_point(generator, 1);
      for (int axis = 0; axis < 3; ++axis)
        if (random_below(generator, 3) == 0) step[axis] = 0;  // held
      places.push_back(places.back() + step);
    }
    auto const kind = k % 2 == 0 ? TableInterpolation::monotone : TableInterpolation::linear;
    auto const fault = fault_of_table(times, places, kind, generator);
    tally.count(fault.empty() ? "" : "table " + std::to_string(k) + ": " + fault);
  }
}

TEST_CASE("way, velocity and acceleration of random composed motions agree", "[R24]") {
  Tally tally("R24");
  tally.note("composed motions");
  auto generator = random_of(243);
  auto const attempt = [&](char const* name, auto const& motion) {
    X const at_rest = random_point(generator, 1);
    double const from = 0.1 * random_below(generator, 10) + random_between(generator, 0.01, 0.08);
    auto const fault = fault_of_path(motion, at_rest, from, from + random_between(generator, 1e-4, 1e-3));
    tally.count(fault.empty() ? "" : std::string(name) + " from " + std::to_string(from) + " s: " + fault);
  };
  for (int k = 0; k < attempts(20, 400); ++k) {
    auto const turn = random_rotation(generator), other = random_rotation(generator);
    auto const shake = random_oscillation(generator);
    auto const path = random_path(generator);
    Translation<3> const slide{.speed = random_point(generator, 1), .growth = random_point(generator, 1)};
    Composed<RotationAbout, RotationAbout> const mixer{turn, other};
    attempt("rotation in a rotation", mixer);
    attempt("oscillation in a rotation", Composed<RotationAbout, Oscillation<3>>{turn, shake});
    attempt("rotation in an oscillation", Composed<Oscillation<3>, RotationAbout>{shake, other});
    attempt("table in a rotation", Composed<RotationAbout, Tabulated<3>>{turn, path});
    attempt("mixer in a translation", Composed<Translation<3>, decltype(mixer)>{slide, mixer});
    attempt("table in a mixer", Composed<decltype(mixer), Tabulated<3>>{mixer, path});
  }
}

}  // namespace scree::test::motions_tests
