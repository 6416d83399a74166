// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../segregation/conservative.hpp"
#include "granular.hpp"

namespace scree {
namespace detail {
template <class S>
concept TakesGravity = requires(S const& segregation) {
  segregation.transport(Resolution{}, Gravity{});
};
}  // namespace detail

/// A granular material of two grain sizes that segregate: the mechanics passes the shear rate to the segregation, which
/// passes the concentration back if the law reads it (Zhu et al. 2024, section 2). Grains segregate along the gravity
/// of the mechanics; the segregation has none of its own.
template <class Mechanics, class Segregation>
struct SegregatingGranular {
  Mechanics mechanics = {};
  Segregation segregation = {};
  /// Steps from one evaluation of the segregation to the next, 1 or more; its rate is constant in between. The speed of
  /// sound limits the steps; the concentration changes with the flow, thousands of times more slowly.
  int period = 1;

  using evolves = Merge<typename Mechanics::evolves, typename Segregation::evolves>;

  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(rate_passes(mechanics, resolution), transport(resolution));
  }
  /// The concentration is updated with the stress, before forces and motion; its rate uses the shear rate of the
  /// previous step.
  auto stages(Resolution const& resolution) const {
    auto const with_transport = [&](auto const& strain, auto const&... others) {
      using Strain = std::remove_cvref_t<decltype(strain)>;
      using Evolved = Merge<typename Strain::evolves, typename Segregation::evolves>;
      auto const passes_of_both = std::tuple_cat(transport(resolution), strain.passes);
      return std::tuple(stage<Evolved>(passes_of_both, strain.projections), others...);
    };
    return std::apply(with_transport, mechanics.stages(resolution));
  }
  auto filters(Resolution const& resolution) const { return mechanics.filters(resolution); }
  int filter_period() const { return mechanics.filter_period(); }
  auto wall_force_passes(Resolution const& resolution) const { return mechanics.wall_force_passes(resolution); }

  auto limits(Resolution const& resolution) const {
    auto const over_period = [n = period](auto const&... each) { return std::tuple(each.over(n)...); };
    return std::tuple_cat(mechanics.limits(resolution), std::apply(over_period, segregation.limits(resolution)));
  }
  auto validity(Resolution const& resolution) const {
    return std::tuple_cat(validity_of(mechanics, resolution), validity_of(segregation, resolution));
  }

 private:
  auto transport(Resolution const& resolution) const {
    static_assert(
        detail::TakesGravity<Segregation>,
        "`segregation` needs a function `transport(resolution, gravity)`: its gravity is that of the mechanics");
    return only_if(resolution.steps % every_so_many(period) == 0, segregation.transport(resolution, mechanics.gravity));
  }
};

}  // namespace scree
