// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>

#include <support/formulations.hpp>

#include <cmath>

// A pendulum in rate form, so that it has the structure of mechanics with a rate law: x is the angle, C = sin(x)
// follows from C' = cos(x) u, and u' = -C. Linear: C' = u. Everything is along the first axis. Solver and integrators
// are those of a simulation.
namespace scree::test {

struct PendulumStrain {
  bool linear;
  using reads = Fields<Position, Velocity>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[concentration_rate] = (linear ? 1 : Kokkos::cos(i[position][0])) * i[velocity][0];
  }
};
struct PendulumForce {
  using reads = Fields<Concentration>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[acceleration].setZero();
    out[acceleration][0] = -i[concentration];
  }
};

struct Pendulum {
  double step = 0.1;  // s
  bool linear = false;
  auto strain() const { return point_pass<Material>("strain", PendulumStrain{linear}); }
  static auto force() { return point_pass<Material>("force", PendulumForce{}); }
  using evolves = Fields<Position, Velocity, Concentration>;
  auto passes(Resolution const&) const { return std::tuple(strain(), force()); }
  auto stages(Resolution const&) const {
    return std::tuple(stage<Fields<Concentration>>(std::tuple(strain())),
                      stage<Fields<Velocity, Position>>(std::tuple(force())));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("step", step)); }
};

/// A formulation with another integrator.
template <class P, class Integrator>
struct Integrated : P {
  using integrator = Integrator;
};
using PendulumPolicy = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
template <class Integrator>
using PendulumWith = Integrated<Formulated<PendulumPolicy, Pendulum>, Integrator>;

struct PendulumState {
  double x, u, C;
};
template <class S>
PendulumState state_of(S const& solver) {
  using namespace fields;
  return {solver.material().to_host(position)[0][0], solver.material().to_host(velocity)[0][0],
          solver.material().to_host(concentration)[0]};
}

/// A pendulum that starts at the lowest point.
template <class Integrator>
Solver<PendulumWith<Integrator>> pendulum(double step, double speed, bool linear = false) {
  auto solver = solver_of<PendulumWith<Integrator>>({{Vec<2, double>::Zero()}, {}}, 1, {step, linear});
  solver.set(fields::velocity, [&](auto const&) { return Vec<2, double>(speed, 0); });
  return solver;
}

}  // namespace scree::test
