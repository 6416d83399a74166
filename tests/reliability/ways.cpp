// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R22: particles in single precision that fly freely, at any speed and at any distance from the origin.
#include "tally.hpp"

#include <scree/neighbours/cell_list.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree::test::ways_tests {
using namespace fields;

struct NoAcceleration {
  using reads = Fields<>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[acceleration].setZero();
  }
};

namespace {

struct Flight {
  using evolves = Fields<Velocity, Position>;
  auto stages(Resolution const&) const {
    return std::tuple(stage<Fields<Velocity, Position>>(std::tuple(point_pass<Material>("none", NoAcceleration{}))));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
struct Flying : Formulation<2, float> {
  using physics = Flight;
  template <class P>
  using search = CellList<P>;
};

double const dt = 1.0 / (1 << 20);  // s

/// A row of particles along the second axis that fly along the first one, each at a speed of its own.
void attempt(Tally& tally, std::mt19937& generator, int steps, int& refused) {
  std::size_t const number = 8;
  double const offset = std::pow(10, random_between(generator, -2, 5)) * (random_below(generator, 2) == 0 ? -1 : 1);
  double const spacing = std::pow(10, random_between(generator, -3, 1));
  // The largest coordinate that float holds to a thousandth of the spacing, docs/choosing.md.
  double const unit_of_coarsest = double(std::numeric_limits<float>::epsilon()),
               most = 1e-3 * spacing / unit_of_coarsest;
  std::string const where = std::to_string(offset) + " m, spacing " + std::to_string(spacing) + " m: ";
  std::vector<Vec<2, float>> start, u;
  for (std::size_t k = 0; k < number; ++k) {
    start.push_back({float(offset), float(double(k) * spacing)});
    double const unit = std::ldexp(1.0, std::ilogb(std::abs(offset)) - 23);
    double const units = std::pow(10, random_between(generator, -3, 2));  // in the last place, in each step
    u.push_back({float((random_below(generator, 2) == 0 ? -1 : 1) * units * unit / dt), 0});
  }
  try {
    Solver<Flying> solver({.spacing = spacing}, start);
    auto next = u.begin();
    solver.set(velocity, [&](auto const&) { return *next++; });
    for (int k = 0; k < steps; ++k) solver.step(dt);
    if (std::abs(offset) > 1.01 * most) return tally.count(where + "is not refused");
    auto const x = solver.material().to_host(position);
    for (std::size_t k = 0; k < number; ++k) {
      double const way = steps * dt * double(u[k][0]), exact = double(start[k][0]) + way;
      double const last_place = std::ldexp(1.0, std::ilogb(exact) - 23), off = std::abs(double(x[k][0]) - exact);
      bool const is_right = off <= 1e-4 * std::abs(way) + last_place;
      tally.count(is_right ? ""
                           : where + std::to_string((double(x[k][0]) - double(start[k][0])) / way) + " of the way");
    }
  } catch (std::invalid_argument const& error) {
    std::string const said = error.what();
    bool const is_due =
        std::abs(offset) > 0.99 * most && said.find("single precision is too coarse") != std::string::npos;
    ++refused;
    tally.count(is_due ? "" : where + said);
  }
}

}  // namespace

TEST_CASE("in single precision particles go the whole way or are refused at any speed, offset and spacing", "[R22]") {
  Tally tally("R22");
  auto generator = random_of(22);
  int refused = 0;
  for (int k = 0; k < attempts(8, 120); ++k) attempt(tally, generator, attempts(500, 3000), refused);
  tally.note("ways of " + std::to_string(attempts(500, 3000)) + " steps, " + std::to_string(refused) +
             " places refused");
}

}  // namespace scree::test::ways_tests
