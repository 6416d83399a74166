// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/read_tabulated.hpp>

#include "kinematics.hpp"

#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>

namespace scree::test::tabulated_tests {
namespace {
using V = Vec<2, double>;
V const origin(0, 0);
std::vector<double> const times{0.5, 1, 1.2, 2.5, 3};
std::vector<V> const places{{0, 0}, {0.1, 0.3}, {0.2, 0.3}, {-0.4, 0.1}, {-0.4, 0}};
}  // namespace

TEST_CASE("a tabulated motion passes through its table and has the derivatives of its path") {
  Tabulated<2> const motion(times, places);
  for (std::size_t k = 0; k < times.size(); ++k)
    CHECK((motion.displaced(origin, 0.0, times[k]) - places[k]).norm() < 1e-15);
  check_kinematics<2>(motion, {0.2, 0.6, 0.9, 1.1, 2.0, 2.7, 3.4});
  check_kinematics<3>(Tabulated<3>({0, 1, 4}, {{0, 0, 0}, {1, 2, 3}, {-1, 0, 1}}), {0.3, 2.2});
}

TEST_CASE("the velocity of a tabulated motion is continuous at its inner times") {
  Tabulated<2> const motion(times, places);
  for (double const t : {1.0, 1.2, 2.5})
    CHECK((motion.velocity(origin, t + 1e-9) - motion.velocity(origin, t - 1e-9)).norm() < 1e-7);
}

TEST_CASE("a wall that moves and is then held stays where it is") {
  Tabulated<2> const motion({0, 1, 2, 100}, {{0, 0}, {1, 0}, {1, 0}, {1, 0}});
  for (double const t : {1.0, 1.5, 2.0, 30.0, 99.0, 1000.0}) {
    CHECK(motion.displaced(origin, 0.0, t) == V(1, 0));
    CHECK(motion.velocity(origin, t) == origin);
  }
}

TEST_CASE("a tabulated motion stays between the two neighbouring points of any table") {
  std::mt19937 random(3);
  auto const part = [&] { return double(random()) / 4294967296.0; };
  for (auto const interpolation : {TableInterpolation::monotone, TableInterpolation::linear})
    for (int n = 0; n < 200; ++n) {
      std::vector<double> at{part()};
      std::vector<V> place{{0, 0}};
      for (int k = 0, count = 1 + int(20 * part()); k < count; ++k) {
        at.push_back(at.back() + std::pow(10, 4 * part() - 2));
        V const step(std::pow(10, 6 * part() - 3) * (2 * part() - 1), std::floor(3 * part()) - 1);
        place.push_back(place.back() + step);
      }
      Tabulated<2> const motion(at, place, interpolation);
      double beyond = 0;
      for (std::size_t k = 0; k + 1 < at.size(); ++k)
        for (double s = 0.01; s < 1; s += 0.0198) {
          V const x = place[0] + motion.displaced(origin, at[0], at[k] + s * (at[k + 1] - at[k]));
          V const low = place[k].cwiseMin(place[k + 1]), high = place[k].cwiseMax(place[k + 1]);
          beyond = std::max({beyond, (low - x).maxCoeff(), (x - high).maxCoeff()});
        }
      CHECK(beyond < 1e-12 * place.back().norm() + 1e-12);
    }
}

TEST_CASE("a finer table of a smooth motion approaches it with the third order of its intervals") {
  using std::numbers::pi;
  double before = 0;
  for (int const n : {16, 32, 64, 128}) {
    std::vector<double> at;
    std::vector<Vec<1, double>> place;
    auto const exact = [](double t) { return t - 0.5 * std::sin(2 * pi * t) / (2 * pi); };
    for (int k = 0; k <= n; ++k) at.push_back(double(k) / n), place.push_back(Vec<1, double>(exact(at.back())));
    Tabulated<1, 129> const motion(at, place);
    double most = 0;
    for (double t = 0.25; t < 0.75; t += 0.003)
      most = std::max(most, std::abs(motion.displaced(Vec<1, double>(0), 0.0, t)[0] - exact(t)));
    if (n > 16) CHECK(before / most > 7);
    before = most;
  }
}

TEST_CASE("a linear table has straight paths, whose velocity jumps") {
  Tabulated<2> const motion(times, places, TableInterpolation::linear);
  CHECK((motion.displaced(origin, 0.0, 0.75) - V(0.05, 0.15)).norm() < 1e-15);
  CHECK((motion.velocity(origin, 0.6) - V(0.2, 0.6)).norm() < 1e-15);
  CHECK(motion.velocity(origin, 0.999) != motion.velocity(origin, 1.001));
  CHECK(motion.velocity(origin, 3.1) == origin);
  check_kinematics<2>(motion, {0.2, 0.6, 0.9, 1.1, 2.0, 2.7, 3.4});
}

TEST_CASE("a motion read from a file is that of its numbers, or its mistake is named by line and column") {
  using Catch::Matchers::ContainsSubstring;
  auto const file = std::filesystem::temp_directory_path() / "scree_tabulated.csv";
  auto const read = [&](std::string const& text) {
    std::ofstream(file, std::ios::binary) << text;
    return read_tabulated<2, 4>(file);
  };
  Tabulated<2, 4> const exact({0, 0.5, 2}, {{0, 0}, {1e-3, 0.25}, {-1, 0.5}});
  for (std::string const text : {"time [s],x [m],z [m]\n0,0,0\n0.5,1e-3,+0.25\n2,-1,.5\n",
                                 "# of a hoist\r\nt (s), x, z\r\n\r\n0, 0, 0\r\n0.5, 0.001, 0.25\r\n2, -1, 0.5",
                                 "0,0,0\n0.5,0.001,0.25\n2,-1,0.5"}) {
    auto const motion = read(text);
    for (double const t : {0.0, 0.3, 0.5, 1.7, 3.0})
      CHECK(motion.displaced(origin, 0.0, t) == exact.displaced(origin, 0.0, t));
  }
  std::string const name = "scree_tabulated.csv, line ";
  CHECK_THROWS_WITH(read("0,0,0\n1,2,x\n"), name + "2, column 3: 'x' is not a number");
  CHECK_THROWS_WITH(read("0,0,0\n1,,1\n"), name + "2, column 2: '' is not a number");
  CHECK_THROWS_WITH(read("0,0,0\n1,inf,1\n"), ContainsSubstring("line 2, column 2: 'inf' is not a finite number"));
  CHECK_THROWS_WITH(read("0,0,0\n1,1\n"), ContainsSubstring("line 2, column 3: there are 2 columns of 3"));
  CHECK_THROWS_WITH(read("0,0,0\n1,1,1,1\n"), ContainsSubstring("line 2, column 4: there are 4 columns of 3"));
  CHECK_THROWS_WITH(read("0;0;0\n1;1;1\n"), ContainsSubstring("line 1, column 2: there are 1 columns of 3"));
  CHECK_THROWS_WITH(read("t [s],x [mm],z [m]\n0,0,0\n"), name + "1, column 2: the unit of 'x [mm]' must be m");
  CHECK_THROWS_WITH(read("t [ms],x [m],z [m]\n0,0,0\n"), name + "1, column 1: the unit of 't [ms]' must be s");
  CHECK_THROWS_WITH(read("0,0,0\n1,1,1\n1,2,2\n"),
                    name + "3, column 1: the time 1 s does not follow 1 s: times must increase");
  CHECK_THROWS_WITH(read("t,x,z\n0,0,0\n"), ContainsSubstring("needs 2 to 4 lines of numbers, not 1"));
  CHECK_THROWS_WITH(read("0,0,0\n1,0,0\n2,0,0\n3,0,0\n4,0,0\n"), ContainsSubstring("2 to 4 lines of numbers, not 5"));
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(read_tabulated<2>(file), ContainsSubstring("cannot read it"));
}

TEST_CASE("a tabulated motion rests before and after its table") {
  Tabulated<2> const motion(times, places);
  for (double const t : {-1.0, 0.5, 3.0, 9.0}) {
    CHECK(motion.velocity(origin, t) == origin);
    CHECK(motion.acceleration(origin, t) == origin);
  }
  CHECK(motion.velocity(origin, 0.5 + 1e-9).norm() < 1e-7);
  CHECK((motion.displaced(origin, 0.0, 99.0) - places[4]).norm() < 1e-15);
  CHECK(Tabulated<2>().displaced(V(1, 2), 0.0, 5.0) == V(1, 2));
}

TEST_CASE("two times make a smooth step") {
  Tabulated<2> const motion({0, 2}, {{0, 0}, {4, 0}});
  CHECK(std::abs(motion.displaced(origin, 0.0, 1.0)[0] - 2) < 1e-15);
  CHECK(std::abs(motion.velocity(origin, 1.0)[0] - 3) < 1e-15);  // 3/2 of the mean
}

TEST_CASE("a bad table stops with a message in words") {
  using Catch::Matchers::StartsWith;
  CHECK_THROWS_WITH(Tabulated<2>({0}, {{0, 0}}), StartsWith("scree: a table of a motion needs 2 to 32 times"));
  CHECK_THROWS_WITH(Tabulated<2>({0, 1}, {{0, 0}}), StartsWith("scree: a table of a motion needs 2 to 32 times"));
  CHECK_THROWS_WITH((Tabulated<2, 4>({0, 1, 2, 3, 4}, std::vector<V>(5, origin))),
                    StartsWith("scree: a table of a motion needs 2 to 4"));
  CHECK_THROWS_WITH(Tabulated<2>({0, 0}, {{0, 0}, {1, 1}}), StartsWith("scree: the times of the table"));
}

TEST_CASE("a step of a tabulated motion is a part of its shortest interval") {
  CHECK(std::abs(Tabulated<2>(times, places).time_step() - 0.02) < 1e-15);
  CHECK(std::isinf(Tabulated<2>().time_step()));
}

}  // namespace scree::test::tabulated_tests
