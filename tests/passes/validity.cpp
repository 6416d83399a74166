// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>
#include <scree/passes/validity.hpp>

#include <support/formulations.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::validity_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

struct Weight {
  using reads = Fields<>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[acceleration] = zero<std::remove_cvref_t<decltype(out[acceleration])>>();
    out[acceleration][1] = -10;
  }
};
/// Particles in free fall, limited to the speed `fastest` (m/s).
struct Falling {
  double fastest = 1e9;
  using evolves = Fields<Velocity, Position>;
  auto passes(Resolution const&) const { return std::tuple(point_pass<Material>("weight", Weight{})); }
  auto limits(Resolution const&) const { return std::tuple(limit("step", 1e-3)); }
  auto validity(Resolution const&) const {
    return std::tuple(bound("speed (m/s)", Magnitude<Velocity>{}, fastest, "brake"));
  }
};
template <class Q, class Motion = AtRest>
using Fall = Formulated<Q, Falling, Motion>;

double const spacing = 0.1;
/// 8 x 4 particles over a floor 0.4 m below.
Bed<2> block_and_floor() {
  return {fill_lattice(Box<2>{{0, 0}, {0.8, 0.4}}, spacing), fill_lattice(Box<2>{{-0.4, -0.7}, {0.7, -0.4}}, spacing)};
}
template <class P>
Solver<P> falling(Bed<2> const& bed, SolverSettings<P> settings = {}) {
  settings.spacing = spacing;
  return Solver<P>(settings, cast<typename P::real>(bed.material), cast<typename P::real>(bed.wall));
}
template <class S>
void throw_all(S& solver, double u, double v) {
  using real = typename S::policy::real;
  solver.set(velocity, [&](auto const&) { return Vec<2, real>(real(u), real(v)); });
}
/// The message that stops the run, or "".
template <class S>
std::string complaint(S& solver, double until) {
  try {
    solver.run(until);
  } catch (OutsideValidity const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a physics stops a run where its model does not hold", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto slow = falling<P>(block_and_floor(), {.physics = {.fastest = 2.8}});
  std::vector<Vec<2, double>> u(32, Vec<2, double>(0, 0));
  u[17] = {0, -0.5};
  std::size_t at = 0;
  slow.set(velocity, [&](auto const&) { return u[at++]; });
  auto const words = complaint(slow, 0.5);
  CHECK_THAT(words, ContainsSubstring("scree: outside the validity of the model: the speed (m/s) must be at most 2.8, "
                                      "and is 3.06") &&
                        ContainsSubstring(" for particle 17 at (") && ContainsSubstring(" m after step ") &&
                        ContainsSubstring("; it is beyond for 1 of 32 particles; brake"));
  // The limit of the step is constant, so that the second check comes after 256 steps.
  CHECK(slow.steps() == 256);
  auto fast = falling<P>(block_and_floor(), {.physics = {.fastest = 5.6}, .lost_share = 1});
  throw_all(fast, 0, -0.5);
  CHECK(complaint(fast, 0.5) == "");
}

TEMPLATE_LIST_TEST_CASE("a start outside of the validity of the model is refused", "", Backends) {
  using P = Fall<Policy<2, float, TestType>>;
  auto solver = falling<P>(block_and_floor(), {.physics = {.fastest = 1}});
  throw_all(solver, 3, 4);
  CHECK_THROWS_MATCHES(solver.step(1), OutsideValidity, MessageMatches(ContainsSubstring("is 5 for particle 0")));
  CHECK(solver.steps() == 0);
}

TEMPLATE_LIST_TEST_CASE("a run looks at its last state, however short it is", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto solver = falling<P>(block_and_floor(), {.physics = {.fastest = 0.5}});
  CHECK(complaint(solver, 0.045) == "");
  CHECK_THAT(complaint(solver, 0.055), ContainsSubstring("must be at most 0.5, and is 0.55 for"));
  auto stopped = falling<P>(block_and_floor(), {.physics = {.fastest = 0.5}});
  CHECK_THROWS_AS(stopped.run(1, {}, [](auto const& s) { return s.time() > 0.0545; }), OutsideValidity);
}

TEMPLATE_LIST_TEST_CASE("material that falls off a floor is lost", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto all = falling<P>(block_and_floor());
  // The bottom of the floor is at -0.65 m, a support is 0.3 m; the lowest row begins at 0.05 m.
  CHECK(complaint(all, 0.44) == "");
  CHECK(all.lost() == 0);
  CHECK_THAT(complaint(all, 0.46),
             ContainsSubstring("the distance beyond the walls (m) must be at most 0.3, and is 0.3"));
  CHECK(all.lost() == 8);

  auto few = falling<P>(block_and_floor(), {.lost_share = 0.25});
  CHECK(complaint(few, 0.46) == "");
  CHECK(few.lost() == 8);
  CHECK_THAT(complaint(few, 0.48), ContainsSubstring("beyond for 16 of 32"));

  auto meant = falling<P>(block_and_floor(), {.lost_share = 1});
  CHECK(complaint(meant, 2) == "");
  CHECK(meant.lost() == 32);
}

TEMPLATE_LIST_TEST_CASE("material may fly above walls, not out to their side", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto up = falling<P>(block_and_floor());
  throw_all(up, 0, 50);
  CHECK(complaint(up, 1) == "");
  CHECK(up.lost() == 0);
  auto aside = falling<P>(block_and_floor());
  throw_all(aside, 20, 5);
  CHECK_THAT(complaint(aside, 0.2), ContainsSubstring("beyond the walls"));
}

TEMPLATE_LIST_TEST_CASE("nothing is lost without walls or along a period", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto free = falling<P>({block_and_floor().material, {}});
  throw_all(free, 100, 0);
  CHECK(complaint(free, 2) == "");
  CHECK(free.lost() == 0);
  Bed<2> const bed{fill_lattice(Box<2>{{0, 0}, {0.8, 0.4}}, spacing),
                   fill_lattice(Box<2>{{0, -10}, {0.8, -9.6}}, spacing)};
  auto periodic = falling<P>(bed, {.periods = {{0, 0, 0.8}}});
  throw_all(periodic, 30, 0);
  CHECK(complaint(periodic, 1) == "");
}

TEMPLATE_LIST_TEST_CASE("walls that move take their place with them", "", Backends) {
  using Q = Policy<2, double, TestType>;
  // The floor moves with the block, to below its landing position.
  auto carried = falling<Fall<Q, Translation<2>>>(block_and_floor(), {.motion = {.speed = {20, -25}}});
  throw_all(carried, 20, -19);
  CHECK(complaint(carried, 1) == "");
  CHECK(carried.lost() == 0);
  // A ring of walls that turns stays where it is.
  auto turned = falling<Fall<Q, Rotation>>(block_and_floor(), {.motion = {.rate = 50}});
  CHECK_THAT(complaint(turned, 2), ContainsSubstring("beyond the walls"));
}

TEMPLATE_LIST_TEST_CASE("material that is put somewhere by hand is not lost there", "", Backends) {
  using P = Fall<Policy<2, double, TestType>>;
  auto solver = falling<P>(block_and_floor());
  solver.set(position, [](auto const& x) { return Vec<2, double>(x[0] + 50, x[1]); });
  CHECK(complaint(solver, 0.1) == "");
}

TEST_CASE("a share of lost particles must be a number") {
  using P = Fall<Policy<2, double, Kokkos::DefaultHostExecutionSpace>>;
  CHECK_THROWS_WITH(falling<P>(block_and_floor(), {.lost_share = std::numeric_limits<double>::quiet_NaN()}),
                    ContainsSubstring("lost_share (-) must be 0 or more, not nan"));
}

}  // namespace scree::test::validity_tests
