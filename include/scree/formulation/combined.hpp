// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../laws/plausible.hpp"
#include "../passes/fuse.hpp"
#include "../passes/limit.hpp"
#include "../passes/stage.hpp"
#include "../passes/validity.hpp"
#include "../terms/carried_momentum.hpp"
#include "../terms/gravity.hpp"
#include "explain.hpp"

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

template <class Transport, class Mechanics>
concept TakesMechanics = requires(Transport const& transport, Mechanics const& mechanics) {
  transport.passes_with(mechanics, Resolution{});
};
template <class Mechanics, class Transport>
concept KnowBedAndGrains = requires(Mechanics const& mechanics, Transport const& transport) {
  double(mechanics.law.density() + transport.closure.grain_density);
};
template <class Physics>
inline constexpr bool has_filters =
    !std::is_same_v<decltype(filters_of(std::declval<Physics const&>(), Resolution{})), Tuple<>>;

}  // namespace detail

/// A mechanics model and a model that transports a quantity with the material, such as a concentration or heat. Both
/// evolve fields of the same particles, and each may read fields of the other by naming them. Further models are added
/// by nesting: Combined<Combined<Granular<>, Segregation>, Heat>.
///
/// `Transport`, like `Mechanics`, is a class with the functions of a physics model. If it has a function
/// passes_with(mechanics, resolution), this function replaces its `passes`: it omits passes that belong to the
/// mechanics, and takes common settings such as gravity from the mechanics.
template <class Mechanics, class Transport>
struct Combined {
  Mechanics mechanics = {};
  Transport transport = {};
  /// The number of steps from one evaluation of the transport to the next, 1 or more; the transport rate is constant in
  /// between. The speed of sound limits the time step, whereas the transported field changes with the flow, thousands
  /// of times more slowly.
  int period = 1;

  static_assert(!detail::has_filters<Transport>, "only the mechanics of Combined may have filters");
  static_assert(detail::explain_options<Mechanics>() && detail::explain_options<Transport>());
  static_assert(detail::TakesMechanics<Transport, Mechanics> || !detail::HasMemberPassesWith<Transport>,
                "`passes_with` of the transport cannot be called with this mechanics: it must be a function "
                "passes_with(mechanics, resolution) const, which returns a tuple of passes");
  static_assert(
      !detail::intersects<evolved_fields<typename Mechanics::evolves>, evolved_fields<typename Transport::evolves>>,
      "both models of Combined evolve the same field: the rate of one would replace that of the other");
  static_assert(detail::explain_carried_momentum<Mechanics, Transport>());
  using evolves = Merge<typename Mechanics::evolves, typename Transport::evolves>;

  /// Returns the passes that compute the rates of both models, those of the mechanics first. The passes of a transport
  /// that carries momentum follow the first stage of the mechanics, because the acceleration reads the carried
  /// momentum. The passes of the transport run only in every `period`-th step, and whenever all rates are computed
  /// afresh.
  auto passes(Resolution const& resolution) const {
    if constexpr (species_with_densities < Mechanics >> 0 && detail::CarriesMass<Transport>) {
      auto const between = [&](auto const& first, auto const&... others) {
        return detail::in_a_row(detail::in_fewer_sweeps(first.passes), transport_passes(resolution),
                                detail::in_fewer_sweeps(detail::in_a_row(others.passes...)));
      };
      return detail::with_values(between, mechanics.stages(resolution));
    } else {
      return detail::in_a_row(detail::rates_of(mechanics, resolution), transport_passes(resolution));
    }
  }
  /// Returns the stages of the mechanics, the first of which also updates the transported fields. The rates of these
  /// fields use results that later passes stored in the previous step.
  auto stages(Resolution const& resolution) const requires detail::HasStages<Mechanics> {
    auto const with_transport = [&](auto const& first, auto const&... others) {
      using First = std::remove_cvref_t<decltype(first)>;
      using Evolved = Merge<typename First::evolves, typename Transport::evolves>;
      auto const passes_of_both = detail::in_a_row(transport_passes(resolution), first.passes);
      auto const projections = detail::in_a_row(first.projections, detail::projections_of(transport, resolution));
      return std::tuple(stage<Evolved>(passes_of_both, projections), others...);
    };
    return detail::with_values(with_transport, mechanics.stages(resolution));
  }
  /// Returns the projections of the mechanics, followed by the projections of the transport.
  auto projections(Resolution const& resolution) const {
    return detail::in_a_row(detail::projections_of(mechanics, resolution),
                            detail::projections_of(transport, resolution));
  }
  /// Returns the filters of the mechanics, or an empty tuple if it has none.
  auto filters(Resolution const& resolution) const { return detail::filters_of(mechanics, resolution); }
  /// Throws std::invalid_argument if the mechanics refuses a bed of this depth (m), see Granular::check_depth().
  void check_depth(double depth) const requires requires(Mechanics const& each) { each.check_depth(depth); }
  { mechanics.check_depth(depth); }
  /// Returns the warning of the mechanics about a bed of this depth (m), see Granular::warning_of_depth().
  std::string warning_of_depth(double depth) const requires requires(Mechanics const& each) {
    each.warning_of_depth(depth);
  }
  { return mechanics.warning_of_depth(depth); }
  /// Returns the warnings of both models, one per line; empty if there are none.
  std::string warning() const {
    return in_lines([](auto const& model) {
      if constexpr (requires { model.warning(); })
        return model.warning();
      else
        return std::string();
    });
  }
  /// Returns the warnings of both models about the present state of a body (WholeBody). A warning is empty if it does
  /// not apply.
  template <class Whole>
  std::vector<std::string> warnings_of_state(Whole const& body) const {
    auto both = scree::warnings_of_state(mechanics, body);
    for (auto& text : scree::warnings_of_state(transport, body)) both.push_back(std::move(text));
    return both;
  }
  /// Returns the largest speed of entering grains that the mechanics allows, m/s.
  double fastest_inlet() const requires requires(Mechanics const& each) { each.fastest_inlet(); }
  { return mechanics.fastest_inlet(); }
  /// Returns the largest speed, m/s, at which the mechanics gives no warning of full layers of rain next to rough
  /// walls.
  double fastest_rain() const requires requires(Mechanics const& each) { each.fastest_rain(); }
  { return mechanics.fastest_rain(); }
  /// Returns the acoustic CFL number set in the mechanics: the time step over h/c_s.
  double acoustic_cfl() const requires requires(Mechanics const& each) { each.acoustic_cfl(); }
  { return mechanics.acoustic_cfl(); }
  /// Returns the number of steps from one run of the filters to the next; 1 if there are no filters.
  int filter_period() const {
    if constexpr (detail::has_filters<Mechanics>)
      return mechanics.filter_period();
    else
      return 1;
  }
  /// Returns the passes of the mechanics that compute `wall_force` for the present state, for output.
  auto wall_force_passes(Resolution const& resolution) const { return mechanics.wall_force_passes(resolution); }
  /// Returns the passes of the mechanics that compute `wall_force` of a body from rates of the present state.
  template <BodyTag Body>
  auto reaction_passes(Resolution const& resolution) const requires requires(Mechanics const& of_motion) {
    of_motion.template reaction_passes<Body>(resolution);
  }
  { return mechanics.template reaction_passes<Body>(resolution); }

  /// Throws std::invalid_argument if a setting of a model or the period is out of range, if the densities of the
  /// species have other ratios in the transport than in the mechanics, or if the closure has grains of a lower density
  /// than the bed.
  void check() const {
    check_settings_of(mechanics);
    check_settings_of(transport);
    check_setting(period >= 1, "period (steps) of the transport in Combined", period, "1 or more");
    if constexpr (GivesSpeciesDensities<Mechanics> && detail::HasDensitiesOfClosure<Transport>)
      detail::check_same_densities(mechanics.species_densities(), transport.closure.densities);
    if constexpr (detail::KnowBedAndGrains<Mechanics, Transport>)
      detail::check_density_of_bed(mechanics.law.density(), transport.closure.grain_density, "the closure");
  }
  /// Returns the time step limits of both models. A limit of the transport covers `period` steps. Throws as the limits
  /// of the two models do.
  auto limits(Resolution const& resolution) const {
    auto const over_period = [n = period](auto const&... each) { return detail::Tuple(each.over(n)...); };
    return detail::in_a_row(mechanics.limits(resolution),
                            detail::with_values(over_period, transport.limits(resolution)));
  }
  /// Returns the bounds on the state of both models, those of the mechanics first.
  auto validity(Resolution const& resolution) const {
    return detail::in_a_row(validity_of(mechanics, resolution), validity_of(transport, resolution));
  }

 private:
  /// Returns the texts that a function returns for the two models, one per line.
  template <class Text>
  std::string in_lines(Text const& text_of) const {
    std::string const first = text_of(mechanics), second = text_of(transport);
    return first + (first.empty() || second.empty() ? "" : "\n") + second;
  }
  auto transport_passes(Resolution const& resolution) const {
    return only_if(resolution.afresh || resolution.steps % every_so_many(period) == 0, passes_of_transport(resolution));
  }
  auto passes_of_transport(Resolution const& resolution) const {
    if constexpr (detail::TakesMechanics<Transport, Mechanics>) {
      return transport.passes_with(mechanics, resolution);
    } else {
      static_assert(!detail::HasGravity<Transport>,
                    "the transport has a gravity of its own, which may differ from that of the mechanics: it needs a "
                    "function `passes_with(mechanics, resolution)` instead");
      return detail::rates_of(transport, resolution);
    }
  }
};

/// Returns the combination of a mechanics model and a transport model that is evaluated every `period` steps.
template <class Mechanics, class Transport>
Combined<Mechanics, Transport> combine(Mechanics const& mechanics, Transport const& transport, int period = 1) {
  return {mechanics, transport, period};
}

}  // namespace scree
