// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/start_in_space.hpp"
#include "formulation.hpp"
#include "settings.hpp"

#include <cstddef>

// Checks of the positions of a solver where its particles are.
namespace scree::detail {

/// Calls use(look) with a StartIn of all particles of a system. Returns false, without a call, if the host has to look
/// at them: if several ranks share them, memory is short, or too many are in one place.
template <class P, class Sys, class Use>
[[gnu::cold]] bool look_in_space(Sys const& system, SolverSettings<P> const& settings, Use const& use) {
  using Space = typename P::space;
  if (system.ranks().several()) return false;
  auto const& material = system.template body<Material>();
  int count = material.size();
  for_each_body(following_bodies<P>{}, [&]<class Body>() { count += system.template body<Body>().size(); });
  if (double(count) * StartIn<Space>::bytes > free_memory<typename Space::memory_space>()) return false;
  Spots<Space> spots(system.space(), count);
  spots.owned = material.size();
  spots.copy(material, 0);
  int first = spots.owned;
  for_each_body(following_bodies<P>{}, [&]<class Body>() {
    spots.copy(system.template body<Body>(), first);
    first += system.template body<Body>().size();
  });
  StartIn<Space> look(spots, settings.spacing, P::dim, settings.periods);
  if (!look.can_look()) return false;
  use(look);
  return true;
}

template <class P>
struct MarkLoaded {
  Columns<P, Fields<Stress>> columns;
  Span<char> marks;
  SCREE_FN void operator()(int i) const {
    auto const sigma = columns.load(fields::stress, i);
    marks(i) = sigma[0] + sigma[1] + sigma[2] < 0;
  }
};
/// Which particles of the material are under pressure.
template <class Body>
auto which_are_loaded(Body const& material) {
  using P = typename Body::policy;
  ArrayIn<char, typename P::space> const marks(material.space(), "scree::loaded", std::size_t(material.size()));
  for_each_index(material.space(), "scree::loaded", 0, material.size(),
                 MarkLoaded<P>{material.select(Fields<Stress>{}), marks});
  return marks;
}

}  // namespace scree::detail
