// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "formulations.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/neighbours/verlet_list.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <string>

// Particles that walls repel, with weak mutual repulsion, and sudden events: tests that neighbour lists notice them.
namespace scree::test {

/// du/dt = -c^2 sum_j V_j grad W.
struct Repulsion {
  using reads = Fields<Volume>;
  using adds = Fields<Acceleration>;
  double squared_speed;  // c^2, m^2/s^2
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[acceleration] += -squared_speed * j[volume] * ij.gradW();
  }
};
struct Repelling {
  double step = 1e-4;  // s
  using evolves = Fields<Velocity, Position>;
  auto passes(Resolution const&) const {
    return std::tuple(pair_pass<Material>("repulsion", over<Material>(Repulsion{0.01}), over<Wall>(Repulsion{9})));
  }
  auto stages(Resolution const& r) const { return std::tuple(stage<evolves>(passes(r))); }
  auto limits(Resolution const&) const { return std::tuple(limit("step", step)); }
};

/// All points stand still until a time (s), and have a velocity (m/s) from then on.
struct SuddenStart {
  double at = 0, speed = 0;
  SCREE_FN double way(double time) const { return Kokkos::max(0.0, time - at) * speed; }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    X y = x;
    y[0] += typename X::Scalar(way(to) - way(from));
    return y;
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    X u = zero<X>();
    if (time > at) u[0] = typename X::Scalar(speed);
    return u;
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  double time_step() const { return 1e-3; }
};

/// Formulations that differ only in their search.
template <class Q, class Motion, class Integrator>
struct WithLists : Formulated<Q, Repelling, Motion> {
  using integrator = Integrator;
  template <class P>
  using search = VerletList<P>;
};
template <class Q, class Motion, class Integrator>
struct WithCells : WithLists<Q, Motion, Integrator> {
  template <class P>
  using search = CellList<P>;
};

namespace sudden {
inline constexpr double spacing = 0.01, end = 0.1;  // m, s

/// 12 x 12 particles at rest, and a plate 6 spacings to their left.
inline Bed<2> block_and_plate() {
  return {fill_lattice(Box<2>{{0, 0}, {0.12, 0.12}}, spacing),
          fill_lattice(Box<2>{{-0.1, -0.04}, {-0.06, 0.16}}, spacing)};
}

/// An action on the solver at half the time.
template <class S>
using Deed = std::function<void(S&)>;

/// Particles that may fly in any direction.
template <class P>
Solver<P> at_rest(typename P::motion const& motion) {
  using real = typename P::real;
  auto const bed = block_and_plate();
  return Solver<P>({.spacing = spacing, .motion = motion, .lost_share = 1}, cast<real>(bed.material),
                   cast<real>(bed.wall));
}

/// The run; positions at its end in the order of the particles.
template <class P>
Solver<P> run(typename P::motion const& motion, Deed<Solver<P>> const& deed) {
  auto solver = at_rest<P>(motion);
  solver.run(end, {every<Solver<P>>(end / 2, [&](Solver<P>& s) {
               if (deed && s.time() > 0 && s.time() < 0.75 * end) deed(s);
             })});
  return solver;
}

/// Lists and cells must give the same positions, up to rounding; returns the solver with lists.
template <class Q, class Integrator, class Motion, class Act>
auto compare(std::string const& name, Motion const& motion, Act const& act) {
  using namespace fields;
  using Lists = WithLists<Q, Motion, Integrator>;
  using Cells = WithCells<Q, Motion, Integrator>;
  auto lists = run<Lists>(motion, [&](auto& s) { act(s); });
  auto const expected = run<Cells>(motion, [&](auto& s) { act(s); }).material().to_host(position);
  auto const found = lists.material().to_host(position);
  double furthest = 0, moved = 0;
  auto const start = block_and_plate().material;
  for (std::size_t i = 0; i < found.size(); ++i) {
    furthest = std::max(furthest, double((found[i] - expected[i]).norm()) / spacing);
    moved = std::max(moved, (expected[i].template cast<double>() - start[i]).norm() / spacing);
  }
  INFO(name << ": particles moved by up to " << moved << " spacings");
  CHECK(furthest < 1e-6);
  CHECK(moved > 3);
  return lists;
}

/// Calls visit(name, motion, act) for all cases; act(solver) happens at half the time.
template <class Visit>
void for_each_case(Visit const& visit) {
  using namespace fields;
  auto const nothing = [](auto&) {};
  auto const velocities = [](auto const& of) {
    return [of](auto& s) { s.set(velocity, [&](auto const& x) { return of(x); }); };
  };
  using V = Vec<2, double>;
  visit("a plate that starts suddenly", SuddenStart{0.05, 4}, nothing);
  visit("a table with a jump", Tabulated<2>({0, 0.05, 0.06, 0.1}, {V(0, 0), V(0, 0), V(0.1, 0), V(0.1, 0)}), nothing);
  visit("a block put against the plate by hand", AtRest{},
        [](auto& s) { s.set(position, [](auto const& x) { return V(x[0] - 0.055, x[1]); }); });
  visit("a block thrown at the plate", AtRest{}, velocities([](V const&) { return V(-3, 0); }));
  visit("a bullet", AtRest{}, velocities([](V const& x) { return x[0] < 0.04 && x[1] < 0.02 ? V(20, 10) : V(0, 0); }));
  visit("an explosion", AtRest{}, velocities([](V const& x) { return V(60 * (x - V(0.06, 0.06))); }));
}
}  // namespace sudden

}  // namespace scree::test
