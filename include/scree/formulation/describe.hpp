// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../snapshots/snapshot_columns.hpp"
#include "formulation.hpp"

#include <string>
#include <string_view>
#include <utility>

// Describes a time step as text: its passes in order, with the fields that they read and write.
namespace scree {
namespace detail {

template <class... Fs>
std::string names_of(Fields<Fs...>) {
  std::string names;
  ((names += (names.empty() ? "" : ", ") + std::string(prefix_of<Fs>) + std::string(Fs::name)), ...);
  return names;
}
inline std::string line(std::string const& head, std::string_view body, std::string const& names) {
  return names.empty() ? "" : "      " + head + std::string(body) + ": " + names + "\n";
}
template <class Pass, class... Bs>
std::string what_it_reads_and_writes(Bodies<Bs...>) {
  return (std::string() + ... + line("reads  ", Bs::name, names_of(reads_of_pass<Bs, Pass>{}))) +
         (std::string() + ... + line("writes ", Bs::name, names_of(writes_of_pass<Bs, Pass>{})));
}

template <class Target, class Where, class Then, class... Overs>
std::string title_of(PairPass<Target, Where, Then, Overs...> const& pass) {
  std::string bodies;
  ((bodies += (bodies.empty() ? "" : " and ") + std::string(Overs::body::name)), ...);
  return std::string(pass.label) + ": " + std::string(Target::name) + " over " + bodies;
}
template <class Target, class Function>
std::string title_of(PointPass<Target, Function> const& pass) {
  return std::string(pass.label) + ": " + std::string(Target::name);
}
template <class Pass>
std::string title_of(OnlyIf<Pass> const& pass) {
  return title_of(pass.pass) + (pass.active ? " (conditional)" : " (conditional, not in this step)");
}
template <class Pass>
std::string title_of(Pass const&) {
  return "a pass without a label";
}

template <class List, class... Passes>
std::string text_of(Tuple<Passes...> const& passes) {
  return with_values(
      [](Passes const&... each) {
        return (std::string() + ... + ("    " + title_of(each) + "\n" + what_it_reads_and_writes<Passes>(List{})));
      },
      passes);
}
template <class List, class Passes>
std::string section(std::string const& title, Passes const& passes) {
  return tuple_size<Passes> == 0 ? "" : "  " + title + "\n" + text_of<List>(passes);
}

template <class Evolved>
std::string update_of() {
  std::string const names = names_of(evolved_fields<Evolved>{});
  return names.empty() ? "" : "  update of " + names + "\n";
}

template <class List, class Evolved, class Passes, class Projections>
std::string text_of(Stage<Evolved, Passes, Projections> const& stage) {
  return section<List>("rates of " + names_of(evolved_fields<Evolved>{}), stage.passes) + update_of<Evolved>() +
         section<List>("projections", stage.projections);
}

}  // namespace detail

/// Returns a text that lists the passes of a physics model in a time step of an integrator, in order: the label of each
/// pass, the body of its targets, the bodies of their neighbours, and the fields that the pass reads and writes. Labels
/// joined by a plus belong to passes that are computed in one sweep. An integrator may run some passes more than once
/// in a step, and may update the state in the same sweep as the last pass before the update.
template <class Integrator, class List = Bodies<Material, Wall>, class Physics>
std::string describe(Physics const& physics, Resolution const& resolution) {
  std::string text;
  if constexpr (detail::Staggered<Integrator>) {
    detail::with_values([&](auto const&... stages) { ((text += detail::text_of<List>(stages)), ...); },
                        physics.stages(resolution));
  } else {
    text = detail::section<List>("rates", detail::rates_of(physics, resolution)) +
           detail::update_of<typename Physics::evolves>() +
           detail::section<List>("projections", detail::projections_of(physics, resolution));
  }
  if constexpr (detail::GivesFilters<Physics>)
    text += detail::section<List>(
        "filters, at every step whose number is a multiple of " + std::to_string(physics.filter_period()),
        detail::filters_of(physics, resolution));
  return text;
}
/// Returns the passes of a time step of a solver, in order, as the other describe() does.
template <class S>
std::string describe(S const& solver) {
  using P = typename S::policy;
  return describe<typename P::integrator, typename P::bodies>(solver.settings().physics, solver.resolution());
}

}  // namespace scree
