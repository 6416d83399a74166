// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "team.hpp"

#include <Kokkos_Timer.hpp>

#include <cstdint>
#include <vector>

namespace scree {

/// Counts and times from when it is made:
///     Profiler const profiler(solver);
///     solver.run(1);
///     for (PartProfile const& part : profiler.of(solver)) ...
class Profiler {
 public:
  template <class S>
  explicit Profiler(S const& solver) : start_(here(solver)) {}
  /// Of all parts, on each. All parts call it together.
  template <class S>
  std::vector<PartProfile> of(S const& solver) const {
    PartProfile part = here(solver);
    part.seconds = timer_.seconds();
    part.steps -= start_.steps, part.builds -= start_.builds, part.migrated -= start_.migrated;
    auto& [exchanges, gathers, messages, bytes, exchanging, gathering] = part.traffic;
    Traffic const& before = start_.traffic;
    exchanges -= before.exchanges, gathers -= before.gathers;
    messages -= before.messages, bytes -= before.bytes;
    exchanging -= before.exchanging, gathering -= before.gathering;
    if constexpr (requires { solver.parts().team(); })
      return solver.parts().team().gather(part);
    else
      return {part};
  }

 private:
  template <class S>
  static PartProfile here(S const& solver) {
    PartProfile part{.steps = solver.steps(), .builds = solver.neighbour_builds()};
    detail::for_each_body(typename S::policy::bodies{}, [&]<class Body>() {
      auto const& body = solver.template body<Body>();
      part.particles += body.size();
      part.ghosts += body.ghosts();
    });
    if constexpr (requires { solver.parts().team(); }) {
      part.migrated = solver.parts().counts().migrated;
      part.traffic = solver.parts().team().traffic();
    }
    return part;
  }

  PartProfile start_;
  Kokkos::Timer timer_;
};

}  // namespace scree
