// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/kept.hpp"
#include "../support/timing.hpp"
#include "census.hpp"
#include "memory.hpp"
#include "phases.hpp"

// Rows of whole steps of a solver.
namespace scree::bench {

/// A solver after some first steps, whose launches and waits were counted.
template <class S>
struct Stepped {
  Memory memory;  // before the solver, whose arrays it counts
  S solver;
  int first_steps;
  Census census;

  template <class Make>
  Stepped(Make const& make, int steps) : solver(make()), first_steps(steps) {
    census = census_of([&] { advance(steps); });
  }
  void advance(int steps) {
    long const last = solver.steps() + steps;
    solver.run(
        solver.time() + 1, {}, [](S const&) { return true; }, [&] { return solver.steps() >= last; });
  }
  double particles() const { return double(solver.material().size()) + solver.wall().size(); }
};

/// Counters next to the time of one step; `builds` and `steps` are those of the timed part.
template <class S>
void count_steps(benchmark::State& state, Stepped<S> const& stepped, double builds, double steps) {
  count_particles(state, stepped.particles());
  state.counters["material"] = stepped.solver.material().size();
  state.counters["rebuilds/step"] = builds / steps;
  state.counters["launches/step"] = double(stepped.census.launches) / stepped.first_steps;
  state.counters["waits/step"] = double(stepped.census.waits) / stepped.first_steps;
  state.counters["bytes/particle"] = stepped.memory.held() / stepped.particles();
  state.counters["most_bytes/particle"] = stepped.memory.most() / stepped.particles();
}

/// Times `steps` steps after `first_steps`, repeatedly.
template <class Make>
benchmark::internal::Benchmark* add_step_row(std::string const& name, int first_steps, int steps, Make const& make) {
  return add_row(name, [=](benchmark::State& state) {
    using S = decltype(make());
    auto& stepped = kept(name, [&] { return Stepped<S>(make, first_steps); });
    long const builds = stepped.solver.neighbour_builds(), before = stepped.solver.steps();
    Kokkos::fence();
    while (state.KeepRunningBatch(steps)) {
      stepped.advance(steps);
      Kokkos::fence();
    }
    count_steps(state, stepped, double(stepped.solver.neighbour_builds() - builds),
                double(stepped.solver.steps() - before));
  });
}

/// Microseconds per step in each kernel, by its label.
template <class Make>
void add_phases_row(std::string const& name, int steps, Make const& make) {
  add_row(name, [=](benchmark::State& state) {
    using S = decltype(make());
    auto& stepped = kept(name, [&] { return Stepped<S>(make, steps); });
    while (state.KeepRunningBatch(steps)) {
      for (auto const& [label, seconds] : phases_of([&] { stepped.advance(steps); }))
        state.counters[label] = 1e6 * seconds / steps;
    }
  });
}

}  // namespace scree::bench
