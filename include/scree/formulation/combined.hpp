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

/// Mechanics and a transport of something with the material, such as a concentration or heat. Both evolve fields of the
/// same particles, and each reads fields of the other where it names them. Further models nest:
/// Combined<Combined<Granular<>, Segregation>, Heat>.
///
/// `Transport` is a class like `Mechanics`, with the functions of a physics model. If it has a function
/// passes_with(mechanics, resolution), this function replaces its `passes`: it leaves out passes of the mechanics, and
/// takes common settings such as gravity from it.
template <class Mechanics, class Transport>
struct Combined {
  Mechanics mechanics = {};
  Transport transport = {};
  /// Steps from one evaluation of the transport to the next, 1 or more; its rate is constant in between. The speed of
  /// sound limits the steps; the transported field changes with the flow, thousands of times more slowly.
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

  /// The passes that compute the rates of both models, those of the mechanics first; of a transport that carries
  /// momentum, after the first stage of the mechanics, because the acceleration reads the carried momentum. The
  /// transport has passes only in every `period`-th step.
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
  /// The transported fields are updated in the first stage of the mechanics. Their rates use results of later passes
  /// from the previous step.
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
  /// The projections of the mechanics, then those of the transport.
  auto projections(Resolution const& resolution) const {
    return detail::in_a_row(detail::projections_of(mechanics, resolution),
                            detail::projections_of(transport, resolution));
  }
  /// The filters of the mechanics; an empty tuple if it has none.
  auto filters(Resolution const& resolution) const { return detail::filters_of(mechanics, resolution); }
  /// Throws std::invalid_argument if the mechanics refuses a bed of this depth (m), see Granular::check_depth().
  void check_depth(double depth) const requires requires(Mechanics const& each) { each.check_depth(depth); }
  { mechanics.check_depth(depth); }
  /// Returns the warning of the mechanics about a bed of this depth (m), see Granular::warning_of_depth().
  std::string warning_of_depth(double depth) const requires requires(Mechanics const& each) {
    each.warning_of_depth(depth);
  }
  { return mechanics.warning_of_depth(depth); }
  /// The warnings of both models, a line each; empty if there are none.
  std::string warning() const {
    return in_lines([](auto const& model) {
      if constexpr (requires { model.warning(); })
        return model.warning();
      else
        return std::string();
    });
  }
  /// The warnings of both models about the state that a body (WholeBody) has come to, each empty if there is none.
  template <class Whole>
  std::vector<std::string> warnings_of_state(Whole const& body) const {
    auto both = scree::warnings_of_state(mechanics, body);
    for (auto& text : scree::warnings_of_state(transport, body)) both.push_back(std::move(text));
    return both;
  }
  /// The largest speed of grains that enter, m/s, as the mechanics allows it.
  double fastest_inlet() const requires requires(Mechanics const& each) { each.fastest_inlet(); }
  { return mechanics.fastest_inlet(); }
  /// The largest speed of full layers of rain that gives no warning next to rough walls, m/s, from the mechanics.
  double fastest_rain() const requires requires(Mechanics const& each) { each.fastest_rain(); }
  { return mechanics.fastest_rain(); }
  /// The step over h/c_s that the mechanics is set to.
  double acoustic_cfl() const requires requires(Mechanics const& each) { each.acoustic_cfl(); }
  { return mechanics.acoustic_cfl(); }
  /// Steps from one run of the filters to the next; 1 if there are none.
  int filter_period() const {
    if constexpr (detail::has_filters<Mechanics>)
      return mechanics.filter_period();
    else
      return 1;
  }
  /// The passes of the mechanics that compute `wall_force` for the present state; for output.
  auto wall_force_passes(Resolution const& resolution) const { return mechanics.wall_force_passes(resolution); }
  /// The passes of the mechanics that compute `wall_force` of a body from rates of the present state.
  template <BodyTag Body>
  auto reaction_passes(Resolution const& resolution) const requires requires(Mechanics const& of_motion) {
    of_motion.template reaction_passes<Body>(resolution);
  }
  { return mechanics.template reaction_passes<Body>(resolution); }

  /// Throws std::invalid_argument if a setting of a model or the period is out of range, or if the closure has grains
  /// of a lower density than the bed.
  void check() const {
    check_settings_of(mechanics);
    check_settings_of(transport);
    check_setting(period >= 1, "period (steps) of the transport in Combined", period, "1 or more");
    if constexpr (GivesSpeciesDensities<Mechanics> && detail::HasDensitiesOfClosure<Transport>)
      detail::check_same_densities(mechanics.species_densities(), transport.closure.densities);
    if constexpr (detail::KnowBedAndGrains<Mechanics, Transport>)
      detail::check_density_of_bed(mechanics.law.density(), transport.closure.grain_density, "the closure");
  }
  /// The limits of the step of both models. A limit of the transport covers `period` steps. Throws as the limits of the
  /// two models do.
  auto limits(Resolution const& resolution) const {
    auto const over_period = [n = period](auto const&... each) { return detail::Tuple(each.over(n)...); };
    return detail::in_a_row(mechanics.limits(resolution),
                            detail::with_values(over_period, transport.limits(resolution)));
  }
  /// The bounds on the state of both models, those of the mechanics first.
  auto validity(Resolution const& resolution) const {
    return detail::in_a_row(validity_of(mechanics, resolution), validity_of(transport, resolution));
  }

 private:
  /// The texts of a function of both models, a line each.
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

/// Returns the combination of a mechanics and a transport, whose rate is evaluated every `period` steps.
template <class Mechanics, class Transport>
Combined<Mechanics, Transport> combine(Mechanics const& mechanics, Transport const& transport, int period = 1) {
  return {mechanics, transport, period};
}

}  // namespace scree
