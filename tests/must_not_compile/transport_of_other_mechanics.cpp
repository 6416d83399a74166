// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `passes_with` of the transport cannot be called with this mechanics
#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>

struct Heat {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
  template <class Mechanics>
#ifdef FIXED
  std::tuple<> passes_with(Mechanics const&, scree::Resolution const&) const {
#else
  std::tuple<> passes_with(scree::Resolution const&, Mechanics const&) const {
#endif
      return {};
}
}
;

scree::Combined<scree::Granular<>, Heat> const physics{};
