// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../pairs/for_each_pair.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../system/system.hpp"
#include "any_pass.hpp"
#include "in_turn.hpp"

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

// A pass is one sweep over the particles of a body. A formulation is a list of passes held as data: to add a pass is to
// add an entry to the list. The lists determine the fields of each body. A pass names bodies or roles: `Material` is
// the body that evolves, and `Wall` is each body that follows a motion.
namespace scree {

/// Terms to be summed over the particles of one body, and a lens that may replace the values of these particles.
template <class Body, class Lens, class... Terms>
struct Over {
  using body = Body;
  using reads = Merge<Without<Merge<Fields<Position>, detail::record_j<Terms>...>, provides_of<Lens>>, reads_of<Lens>>;
  using reads_i = Merge<detail::record_i<Terms>..., reads_i_of<Lens>>;
  using adds = Merge<adds_of<Terms>...>;
  Lens lens;
  detail::Tuple<Terms...> terms;
};
/// Returns the terms that a pass sums over the neighbours in a body.
template <BodyTag Body, class... Terms>
Over<Body, AsIs, Terms...> over(Terms... terms) {
  return {AsIs{}, {terms...}};
}
/// Returns the terms that a pass sums over the neighbours in a body, with the values that a lens gives for the
/// neighbours.
template <BodyTag Body, class Lens, class... Terms>
Over<Body, Lens, Terms...> over_through(Lens lens, Terms... terms) {
  return {lens, {terms...}};
}

namespace detail {
/// Calls visit.template operator()<Body>() for each body of a system that a pass names.
template <class Named, class Sys, class Visit>
void for_each_named(Sys const&, Visit const& visit) {
  for_each_body(bodies_named<Named, typename Sys::bodies>{}, visit);
}
}  // namespace detail

/// A pass that sums terms over the neighbours of each particle of the target body and then calls `then` with the sums,
/// or stores the sums.
template <class Target, class Where, class Then, class... Overs>
struct PairPass {
  using bodies = Bodies<Target, typename Overs::body...>;
  PassLabel label;
  Where where;
  Then then;
  detail::Tuple<Overs...> overs;

  /// Whether the particles of a source may be targets as well.
  template <class Source>
  static constexpr bool among_targets = detail::covers<Source, Target> || detail::covers<Target, Source>;

  using adds = Merge<typename Overs::adds...>;
  using stored = typename std::conditional_t<stores_sums<Then>, std::type_identity<adds>,
                                             std::type_identity<writes_of<Then>>>::type;
  /// The fields of a body that the pass reads from neighbours.
  template <class Body>
  using reads_j =
      Merge<std::conditional_t<detail::covers<typename Overs::body, Body>, typename Overs::reads, Fields<>>...>;
  template <class Body>
  using reads =
      Merge<std::conditional_t<detail::covers<Target, Body>,
                               Merge<Fields<Position>, typename Overs::reads_i..., reads_of<Where>, reads_of<Then>>,
                               Fields<>>,
            reads_j<Body>>;
  template <class Body>
  using writes = std::conditional_t<detail::covers<Target, Body>, stored, Fields<>>;
  template <class Body>
  using fields = Merge<reads<Body>, writes<Body>>;

  static_assert(
      (!(among_targets<typename Overs::body> && detail::intersects<stored, typename Overs::reads>)&&...),
      "a pass must not store a field that it reads of neighbours: the result would depend on the order of the loop");

  /// Whether a function of the particle that writes these fields may be fused with this pass. The pass must have a
  /// function of the sums as its `then`, and no target may read these fields from neighbours.
  template <class Written>
  static constexpr bool may_write =
      !stores_sums<Then> &&
      (!(among_targets<typename Overs::body> && detail::intersects<Written, typename Overs::reads>)&&...);
  /// Returns this pass fused with a function of the particle, which is called after `then`.
  template <class P, class Function>
  auto followed_by(Function const& function) const {
    auto const both = in_turn<P>(then, function);
    return PairPass<Target, Where, std::remove_const_t<decltype(both)>, Overs...>{label, where, both, overs};
  }

  /// Refreshes the fields of ghosts that the pass reads, and runs the pass over all particles of the target body.
  template <class Sys>
  void run(Sys& system) const {
    detail::run_alone(system, *this);
  }
  /// Returns the pass as a value for a system.
  template <class Sys>
  detail::AnyPass value() const {
    return {.label = label,
            .reads_of_ghosts = Sys::template columns<detail::ReadOfNeighbours<PairPass>>.data(),
            .changes = Sys::template columns<detail::WrittenBy<PairPass>>.data(),
            .loops = loops<Sys>,
            .pass = this};
  }

 private:
  template <class Sys>
  static void loops(void const* address, void* system_address) {
    auto const& pass = *static_cast<PairPass const*>(address);
    Sys& system = *static_cast<Sys*>(system_address);
    system.check_ghosts(Sys::template columns<detail::ReadOfNeighbours<PairPass>>.data());
    PairLoopOptions<typename Sys::policy, Where, Then> const options{pass.label, system.kernel(), pass.where,
                                                                     pass.then};
    detail::for_each_named<Target>(system, [&]<class Body>() { pass.template run_for<Body>(system, options); });
  }
  // This function is separate because nvcc 13 cannot expand a parameter pack of the class in a nested lambda.
  template <class Body, class Sys, class Options>
  void run_for(Sys& system, Options const& options) const {
    auto const& targets = system.template body<Body>();
    if constexpr ((is_one<typename Overs::body, Sys> && ...)) {  // compiles faster without tuples
      detail::with_values(
          [&](Overs const&... each) {
            for_each_pair(options, targets,
                          source<typename Overs::body>(system, system.template neighbours<Body, typename Overs::body>(),
                                                       each)...);
          },
          overs);
    } else {
      auto const sources = detail::with_values(
          [&](auto const&... each) { return detail::in_a_row(sources_of<Body>(system, each)...); }, overs);
      detail::with_values([&](auto const&... each) { for_each_pair(options, targets, each...); }, sources);
    }
  }
  /// Whether the name of a body or of a role refers to exactly one body of the system.
  template <class Named, class Sys>
  static constexpr bool is_one = bodies_named<Named, typename Sys::bodies>::count == 1;

  template <class TargetBody, class Sys, class Named, class Lens, class... Terms>
  static auto sources_of(Sys& system, Over<Named, Lens, Terms...> const& each) {
    return [&]<class... Bs>(Bodies<Bs...>) {
      return detail::Tuple(source<Bs>(system, system.template neighbours<TargetBody, Bs>(), each)...);
    }(bodies_named<Named, typename Sys::bodies>{});
  }
  template <class Body, class Sys, class Search, class Lens, class Named, class... Terms>
  static auto source(Sys& system, Search const& search, Over<Named, Lens, Terms...> const& each) {
    auto const& body = system.template body<Body>();
    return From<std::remove_cvref_t<decltype(body)>, Search, Lens, Terms...>{body, search, each.lens, each.terms};
  }
};

/// A pass that calls a function for each particle of the target body.
template <class Target, class Function>
struct PointPass {
  using bodies = Bodies<Target>;
  PassLabel label;
  Function function;
  template <class Body>
  using reads = std::conditional_t<detail::covers<Target, Body>, reads_of<Function>, Fields<>>;
  template <class Body>
  using writes = std::conditional_t<detail::covers<Target, Body>, writes_of<Function>, Fields<>>;
  template <class Body>
  using fields = Merge<reads<Body>, writes<Body>>;
  /// Runs the function for each particle of the target body.
  template <class Sys>
  void run(Sys& system) const {
    detail::run_alone(system, *this);
  }
  /// Returns the pass as a value for a system.
  template <class Sys>
  detail::AnyPass value() const {
    return {.label = label,
            .changes = Sys::template columns<detail::WrittenBy<PointPass>>.data(),
            .moves = OneOf<Position, writes_of<Function>>,
            .loops = loops<Sys>,
            .pass = this};
  }

 private:
  template <class Sys>
  static void loops(void const* address, void* system_address) {
    auto const& pass = *static_cast<PointPass const*>(address);
    Sys& system = *static_cast<Sys*>(system_address);
    detail::for_each_named<Target>(system, [&]<class Body>() {
      for_each_particle<typename Sys::policy>(pass.label, system.template body<Body>(), pass.function);
    });
  }
};

/// Returns a pass that sums terms over neighbours and stores the sums.
template <BodyTag Target, class... Overs>
PairPass<Target, Everywhere, StoreSums, Overs...> pair_pass(PassLabel const& label, Overs... overs) {
  return {label, {}, {}, {overs...}};
}
/// Returns a pass that sums terms over neighbours and calls a function of each particle with its sums.
template <BodyTag Target, class Then, class... Overs>
PairPass<Target, Everywhere, Then, Overs...> pair_pass_then(PassLabel const& label, Then then, Overs... overs) {
  return {label, {}, then, {overs...}};
}
/// Returns a pass that sums terms over neighbours only for the particles that satisfy a condition, and calls a function
/// of each particle with its sums. The sums of all other particles are zero.
template <BodyTag Target, class Where, class Then, class... Overs>
PairPass<Target, Where, Then, Overs...> pair_pass_where(PassLabel const& label, Where where, Then then,
                                                        Overs... overs) {
  return {label, where, then, {overs...}};
}
/// Returns a pass that calls a function for each particle of a body.
template <BodyTag Target, class Function>
PointPass<Target, Function> point_pass(PassLabel const& label, Function function) {
  return {label, function};
}

namespace detail {
// A pass without separate lists of the fields that it reads and writes may read and write all fields in its list
// `fields`.
template <class Body, class Pass>
struct pass_reads {
  using type = typename Pass::template fields<Body>;
};
template <class Body, class Pass>
requires requires { typename Pass::template reads<Body>; }
struct pass_reads<Body, Pass> {
  using type = typename Pass::template reads<Body>;
};
template <class Body, class Pass>
struct pass_writes {
  using type = typename Pass::template fields<Body>;
};
template <class Body, class Pass>
requires requires { typename Pass::template writes<Body>; }
struct pass_writes<Body, Pass> {
  using type = typename Pass::template writes<Body>;
};
}  // namespace detail

template <class Pass>
struct OnlyIf;

/// The bodies and roles that a pass names; by default the roles `Material` and `Wall`, which every formulation has.
template <class Pass>
struct bodies_of_pass {
  using type = Bodies<Material, Wall>;
};
template <class Pass>
requires requires { typename Pass::bodies; }
struct bodies_of_pass<Pass> {
  using type = typename Pass::bodies;
};
template <class Pass>
struct bodies_of_pass<OnlyIf<Pass>> : bodies_of_pass<Pass> {};

/// The fields of a body that a pass reads, from its targets or from neighbours.
template <class Body, class Pass>
using reads_of_pass = typename detail::pass_reads<Body, Pass>::type;
/// The fields of a body that a pass writes.
template <class Body, class Pass>
using writes_of_pass = typename detail::pass_writes<Body, Pass>::type;

/// A pass that runs only if a flag is set at run time.
template <class Pass>
struct OnlyIf {
  bool active;
  Pass pass;
  template <class Body>
  using fields = typename Pass::template fields<Body>;
  template <class Body>
  using reads = reads_of_pass<Body, Pass>;
  template <class Body>
  using writes = writes_of_pass<Body, Pass>;
  /// Runs the pass if it is active.
  template <class Sys>
  void run(Sys& system) const {
    detail::run_alone(system, *this);
  }
  /// Returns the pass as a value for a system.
  template <class Sys>
  detail::AnyPass value() const {
    detail::AnyPass value = detail::any_pass<Sys>(pass);
    value.active = active;
    return value;
  }
};
namespace detail {
template <class... Ts>
inline constexpr bool gives_value<PairPass<Ts...>> = true;
template <class... Ts>
inline constexpr bool gives_value<PointPass<Ts...>> = true;
template <class Pass>
inline constexpr bool gives_value<OnlyIf<Pass>> = true;
}  // namespace detail

/// Returns passes that run only if `active` is true.
template <detail::AnyTuple Passes>
auto only_if(bool active, Passes const& passes) {
  return detail::with_values(
      [&](auto const&... each) {
        return std::tuple(OnlyIf<std::remove_cvref_t<decltype(each)>>{active, each}...);
      },
      passes);
}

namespace detail {
template <class Body, class Passes>
struct pass_fields;
template <class Body, class... Passes>
struct pass_fields<Body, Tuple<Passes...>> {
  using type = Merge<typename Passes::template fields<Body>...>;
  using written = Merge<writes_of_pass<Body, Passes>...>;
};
}  // namespace detail

/// The fields of one body that the passes of a list read or store.
template <class Body, class Passes>
using fields_of_passes = typename detail::pass_fields<Body, detail::tuple_of<Passes>>::type;
/// The fields of one body that the passes of a list store.
template <class Body, class Passes>
using fields_written_by = typename detail::pass_fields<Body, detail::tuple_of<Passes>>::written;

}  // namespace scree
