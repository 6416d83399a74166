// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "team.hpp"

#include <Kokkos_Timer.hpp>

#include <cstdint>
#include <vector>

namespace scree {

/// Counts and times since the construction of this object:
///     Profiler const profiler(solver);
///     solver.run(1);
///     for (RankProfile const& rank : profiler.of(solver)) ...
class Profiler {
 public:
  /// Starts counting and starts the clock.
  template <class S>
  explicit Profiler(S const& solver) : start_(here(solver)) {}
  /// Returns, on every rank, the profiles of all ranks. All ranks call this function together.
  template <class S>
  std::vector<RankProfile> of(S const& solver) const {
    RankProfile rank = here(solver);
    rank.seconds = timer_.seconds();
    rank.steps -= start_.steps, rank.builds -= start_.builds, rank.migrated -= start_.migrated;
    auto& [exchanges, gathers, messages, bytes, exchanging, gathering] = rank.traffic;
    Traffic const& before = start_.traffic;
    exchanges -= before.exchanges, gathers -= before.gathers;
    messages -= before.messages, bytes -= before.bytes;
    exchanging -= before.exchanging, gathering -= before.gathering;
    if constexpr (requires { solver.ranks().team(); })
      return solver.ranks().team().gather(rank);
    else
      return {rank};
  }

 private:
  template <class S>
  static RankProfile here(S const& solver) {
    RankProfile rank{.steps = solver.steps(), .builds = solver.neighbour_builds()};
    detail::for_each_body(typename S::policy::bodies{}, [&]<class Body>() {
      auto const& body = solver.template body<Body>();
      rank.particles += body.size();
      rank.ghosts += body.ghosts();
    });
    if constexpr (requires { solver.ranks().team(); }) {
      rank.migrated = solver.ranks().counts().migrated;
      rank.traffic = solver.ranks().team().traffic();
    }
    return rank;
  }

  RankProfile start_;
  Kokkos::Timer timer_;
};

}  // namespace scree
