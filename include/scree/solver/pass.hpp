// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../pairs/for_each_pair.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../pairs/in_turn.hpp"
#include "system.hpp"

#include <tuple>

// A pass is one sweep over the particles of a body. Formulations are lists of passes, as data: adding a pass means
// adding an entry to a list. The lists determine the fields of each body.
namespace scree {

/// Terms summed over the particles of one body, seen through a lens.
template <class Body, class Lens, class... Terms>
struct Over {
  using body = Body;
  using reads = Merge<Without<Merge<Fields<Position>, reads_of<Terms>...>, provides_of<Lens>>, reads_of<Lens>>;
  using reads_i = Merge<reads_of<Terms>..., reads_i_of<Terms>..., reads_i_of<Lens>>;
  using adds = Merge<adds_of<Terms>...>;
  Lens lens;
  std::tuple<Terms...> terms;
};
template <BodyTag Body, class... Terms>
Over<Body, AsIs, Terms...> over(Terms... terms) {
  return {AsIs{}, {terms...}};
}
template <BodyTag Body, class Lens, class... Terms>
Over<Body, Lens, Terms...> over_through(Lens lens, Terms... terms) {
  return {lens, {terms...}};
}

/// For each particle of the target body: sums over neighbours, then the function `then` of the sums.
template <class Target, class Where, class Then, class... Overs>
struct PairPass {
  char const* label;
  Where where;
  Then then;
  std::tuple<Overs...> overs;

  using adds = Merge<typename Overs::adds...>;
  using stored = typename std::conditional_t<Then::stores_sums, std::type_identity<adds>,
                                             std::type_identity<writes_of<Then>>>::type;
  template <class Body>
  using fields =
      Merge<std::conditional_t<
                std::is_same_v<Body, Target>,
                Merge<Fields<Position>, typename Overs::reads_i..., reads_of<Where>, reads_of<Then>, stored>, Fields<>>,
            std::conditional_t<std::is_same_v<Body, typename Overs::body>, typename Overs::reads, Fields<>>...>;

  template <class Body>
  using writes = std::conditional_t<std::is_same_v<Body, Target>, stored, Fields<>>;

  static_assert(
      (!(std::is_same_v<typename Overs::body, Target> && detail::intersects<stored, typename Overs::reads>)&&...),
      "a pass must not store a field that it reads of neighbours: the result would depend on the order of the loop");

  /// Whether a function of the particles that writes these fields may be fused with this pass: no neighbour reads them.
  template <class Written>
  static constexpr bool may_write =
      !Then::stores_sums &&
      (!(std::is_same_v<typename Overs::body, Target> && detail::intersects<Written, typename Overs::reads>)&&...);
  /// This pass fused with a function of the particle that runs after it.
  template <class P, class Function>
  auto followed_by(Function const& function) const {
    auto const both = in_turn<P>(then, function);
    return PairPass<Target, Where, std::remove_const_t<decltype(both)>, Overs...>{label, where, both, overs};
  }

  template <class Sys>
  void run(Sys& system) const {
    using P = typename Sys::policy;
    PairLoopOptions<P, Where, Then> const options{label, system.kernel(), where, then};
    std::apply(
        [&](Overs const&... each) {
          (system.template refresh_ghosts<typename Overs::body>(typename Overs::reads{}), ...);
          for_each_pair(options, system.template body<Target>(), sources<P>(system, each)...);
        },
        overs);
  }

 private:
  template <class P, class Sys, class Body, class Lens, class... Terms>
  static auto sources(Sys& system, Over<Body, Lens, Terms...> const& each) {
    auto const& body = system.template body<Body>();
    auto const& search = system.template neighbours<Target, Body>();
    return From<std::remove_cvref_t<decltype(body)>, std::remove_cvref_t<decltype(search)>, Lens, Terms...>{
        body, search, each.lens, each.terms};
  }
};

/// A function of each particle of a body.
template <class Target, class Function>
struct PointPass {
  char const* label;
  Function function;
  template <class Body>
  using fields =
      std::conditional_t<std::is_same_v<Body, Target>, Merge<reads_of<Function>, writes_of<Function>>, Fields<>>;
  template <class Body>
  using writes = std::conditional_t<std::is_same_v<Body, Target>, writes_of<Function>, Fields<>>;
  template <class Sys>
  void run(Sys& system) const {
    for_each_particle<typename Sys::policy>(label, system.template body<Target>(), function);
    if constexpr (OneOf<Position, writes_of<Function>>) system.positions_changed();
  }
};

/// A pass that stores its sums.
template <BodyTag Target, class... Overs>
PairPass<Target, Everywhere, StoreSums, Overs...> pair_pass(char const* label, Overs... overs) {
  return {label, {}, {}, {overs...}};
}
/// A pass that passes its sums to a function of the particle.
template <BodyTag Target, class Then, class... Overs>
PairPass<Target, Everywhere, Then, Overs...> pair_pass_then(char const* label, Then then, Overs... overs) {
  return {label, {}, then, {overs...}};
}
/// The same for particles that satisfy a condition; for all others the sums are zero.
template <BodyTag Target, class Where, class Then, class... Overs>
PairPass<Target, Where, Then, Overs...> pair_pass_where(char const* label, Where where, Then then, Overs... overs) {
  return {label, where, then, {overs...}};
}
template <BodyTag Target, class Function>
PointPass<Target, Function> point_pass(char const* label, Function function) {
  return {label, function};
}

namespace detail {
/// A pass that does not declare its writes may write all fields that it names.
template <class Body, class Pass>
struct writes_of_pass {
  using type = typename Pass::template fields<Body>;
};
template <class Body, class Pass>
requires requires { typename Pass::template writes<Body>; }
struct writes_of_pass<Body, Pass> {
  using type = typename Pass::template writes<Body>;
};
}  // namespace detail

/// A pass that runs only under a condition at run time.
template <class Pass>
struct OnlyIf {
  bool active;
  Pass pass;
  template <class Body>
  using fields = typename Pass::template fields<Body>;
  template <class Body>
  using writes = typename detail::writes_of_pass<Body, Pass>::type;
  template <class Sys>
  void run(Sys& system) const {
    if (active) pass.run(system);
  }
};
template <class... Passes>
std::tuple<OnlyIf<Passes>...> only_if(bool active, std::tuple<Passes...> const& passes) {
  return std::apply([&](Passes const&... each) { return std::tuple(OnlyIf<Passes>{active, each}...); }, passes);
}

namespace detail {
template <class Body, class Passes>
struct pass_fields;
template <class Body, class... Passes>
struct pass_fields<Body, std::tuple<Passes...>> {
  using type = Merge<typename Passes::template fields<Body>...>;
  using written = Merge<typename writes_of_pass<Body, Passes>::type...>;
};
}  // namespace detail

/// All fields of one body that a list of passes reads or stores.
template <class Body, class Passes>
using fields_of_passes = typename detail::pass_fields<Body, Passes>::type;
/// The fields of one body that a list of passes stores.
template <class Body, class Passes>
using fields_written_by = typename detail::pass_fields<Body, Passes>::written;

/// Runs a list of passes in order.
template <class Sys, class... Passes>
void run_passes(Sys& system, std::tuple<Passes...> const& passes) {
  std::apply([&](Passes const&... each) { (each.run(system), ...); }, passes);
}

namespace detail {
template <class Target, class Passes>
inline constexpr bool are_point_passes = false;
template <class Target, class... Functions>
inline constexpr bool are_point_passes<Target, std::tuple<PointPass<Target, Functions>...>> = true;
}  // namespace detail

/// Fuses a function of a particle with those of point passes.
template <class P, class Function, class... PointPasses>
auto with_point_passes(Function const& function, std::tuple<PointPasses...> const& passes) {
  return std::apply([&](auto const&... each) { return in_turn<P>(function, each.function...); }, passes);
}

namespace detail {
template <class Target, class Pass, class Written>
inline constexpr bool may_be_followed = false;
template <class Target, class Where, class Then, class... Overs, class Written>
inline constexpr bool may_be_followed<Target, PairPass<Target, Where, Then, Overs...>, Written> =
    PairPass<Target, Where, Then, Overs...>::template may_write<Written>;

template <class Passes>
using last_of = std::tuple_element_t<std::tuple_size_v<Passes> - 1, Passes>;
}  // namespace detail

/// Runs a list of passes in order, and then a function of each particle of the target body. The function is fused with
/// the last pass if that pass is over the target body and reads nothing of neighbours that the function writes.
template <class Target, class Sys, class Function, class... Passes>
void run_passes_and(Sys& system, std::tuple<Passes...> const& passes, Function const& function) {
  using Last = detail::last_of<std::tuple<PointPass<Target, Function>, Passes...>>;
  if constexpr (detail::may_be_followed<Target, Last, writes_of<Function>>) {
    [&]<std::size_t... K>(std::index_sequence<K...>) { (std::get<K>(passes).run(system), ...); }
    (std::make_index_sequence<sizeof...(Passes) - 1>());
    std::get<sizeof...(Passes) - 1>(passes).template followed_by<typename Sys::policy>(function).run(system);
  } else {
    run_passes(system, passes);
    point_pass<Target>("scree::update", function).run(system);
  }
}

}  // namespace scree
