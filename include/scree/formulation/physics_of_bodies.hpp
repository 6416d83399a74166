// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/wall.hpp"
#include "../core/setting.hpp"
#include "../core/tuple.hpp"
#include "../passes/on_body.hpp"
#include "../passes/stage.hpp"
#include "../terms/gravity.hpp"
#include "explain.hpp"
#include "formulation.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace scree {

/// A body and the physics model that advances it.
template <EvolvingBody Body, class Physics>
struct EvolvedBy {
  using body = Body;
  using type = Physics;
};

namespace detail {

/// Whether a physics model has interface terms with another model of PhysicsOfBodies: terms for pairs of a particle in
/// its own body and a neighbour in the body of the other model.
template <class Physics, class Other>
concept HasInterface = requires(Physics const& physics, Other const& other) {
  std::tuple_size<decltype(physics.interface_terms(other, Resolution{}))>::value;
};

/// Reports missing interface terms, with one message for all pairs of bodies.
template <bool HasInterface>
constexpr void explain_interface() {
  static_assert(HasInterface,
                "a model of PhysicsOfBodies needs a function interface_terms(other, resolution), the terms of its "
                "particles with neighbours in a body of another model");
}

template <class Physics>
inline constexpr bool is_over_material_alone = is_over_material<typename stages_traits<stages_of<Physics>>::passes>&&
    is_over_material<decltype(filters_of(std::declval<Physics const&>(), Resolution{}))>;
template <class... Parts>
struct ExplainModels<PhysicsOfBodies<Parts...>> {
  static constexpr bool explain() {
    if constexpr ((explain_physics<typename Parts::type>() && ...)) {
      constexpr bool have_stages = (HasStages<typename Parts::type> && ...);
      static_assert(have_stages, "each model of PhysicsOfBodies needs a function `stages(resolution)`");
      if constexpr (have_stages) {
        constexpr bool are_alone = (is_over_material_alone<typename Parts::type> && ...);
        static_assert(are_alone,
                      "each model of PhysicsOfBodies has passes over the particles of its own body, `Material`, alone: "
                      "what it stores on walls would be replaced by what the next model stores there, so walls need a "
                      "scheme without passes, such as MirrorWalls");
        return are_alone && (explain_options<typename Parts::type>() && ...);
      }
    }
    return false;
  }
};

/// Whether passes of one list read fields of a body that passes of another list write.
template <class Body, class Passes, class Others>
inline constexpr bool read_what_others_store = false;
template <class Body, class... Passes, class Others>
inline constexpr bool read_what_others_store<Body, Tuple<Passes...>, Others> =
    (intersects<reads_of_pass<Body, Passes>, fields_written_by<Body, Others>> || ...);

template <class Physics>
inline constexpr std::size_t number_of_stages =
    tuple_size<decltype(std::declval<Physics const&>().stages(Resolution{}))>;

}  // namespace detail

/// The `physics` of a formulation with several evolving bodies, with one physics model for each body:
///   using bodies = Bodies<Sand, Block, Wall>;
///   using physics = PhysicsOfBodies<EvolvedBy<Sand, Granular<Dry>>, EvolvedBy<Block, Granular<Rubber>>>;
/// The constructor takes the models in the order of this list. Each body has the law, fields and stages of its model.
/// Stages with the same number run together: the rates of all bodies are evaluated before any body is updated. A
/// particle also sums over neighbours in the other bodies, with the interface terms of its model. The function
/// interface_terms(other, resolution) returns these terms as a tuple, where `other` is the model of the other body.
/// Each pass uses those interface terms that add to the fields that the pass sums over its own body. Filters act within
/// each body.
template <class... Parts>
class PhysicsOfBodies {
  static constexpr std::size_t number = std::min({detail::number_of_stages<typename Parts::type>...});
  template <class Body>
  static constexpr std::size_t index = detail::index_among<Body>(Bodies<typename Parts::body...>{});
  template <class Body>
  using model_of = typename detail::type_at<index<Body>, detail::Tuple<Parts...>>::type;
  template <class Part, std::size_t K>
  using stage_of = detail::type_at<K, detail::stages_of<typename Part::type>>;

  static_assert(((detail::number_of_stages<typename Parts::type> == number) && ...),
                "the models of PhysicsOfBodies have stages that differ in number, so that they cannot run together");
  static_assert((OneOf<Position, evolved_fields<typename Parts::type::evolves>> && ...),
                "each model of PhysicsOfBodies evolves the position of its body");

 public:
  using bodies = Bodies<typename Parts::body...>;
  using evolves = Merge<typename Parts::type::evolves...>;
  using Walls = typename detail::walls_of<typename detail::type_at<0, detail::Tuple<Parts...>>::type>::type;
  static_assert((std::is_same_v<Walls, typename detail::walls_of<typename Parts::type>::type> && ...),
                "the models of PhysicsOfBodies have walls of different schemes");

  PhysicsOfBodies() = default;
  /// Takes one model for each body, in the order of `bodies`.
  explicit PhysicsOfBodies(typename Parts::type const&... models) : models_(models...) {}

  /// Returns the model of a body of `bodies`.
  template <BodyTag Body>
  requires detail::is_listed<Body, bodies>
  auto const& of_body() const { return std::get<index<Body>>(models_); }
  template <BodyTag Body>
  requires detail::is_listed<Body, bodies>
  auto& of_body() { return std::get<index<Body>>(models_); }

  /// Returns the combined stages of the models: each stage contains the passes of all bodies.
  auto stages(Resolution const& resolution) const {
    auto const of_bodies = detail::Tuple(of_body<typename Parts::body>().stages(resolution)...);
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
      return std::tuple(stage_of_all<K>(of_bodies, resolution)...);
    }
    (std::make_index_sequence<number>());
  }
  /// Returns the filters of all bodies; the filters of each body run in the steps of its own period.
  auto filters(Resolution const& resolution) const {
    return detail::in_a_row(filters_of<typename Parts::body>(resolution)...);
  }
  /// Returns 1, because filters() selects the steps in which each body is filtered.
  static int filter_period() { return 1; }

  /// Throws std::invalid_argument if a setting of a model is out of range, or if the models differ in gravity.
  void check() const {
    std::apply([](auto const&... each) { (check_settings_of(each), ...); }, models_);
    std::optional<Gravity> first;
    auto const compare = [&]<class Model>(Model const& model) {
      if constexpr (detail::HasGravity<Model>) {
        if (!first) first = model.gravity;
        if (!(model.gravity == *first))
          throw std::invalid_argument("scree: the models of PhysicsOfBodies have gravities that differ");
      }
    };
    std::apply([&](auto const&... each) { (compare(each), ...); }, models_);
  }
  /// Returns the largest acoustic CFL number of the models, for comparison with the largest one of the integrator; 0 if
  /// no model has one.
  double acoustic_cfl() const {
    auto const of = [](auto const& model) {
      if constexpr (requires { model.acoustic_cfl(); })
        return model.acoustic_cfl();
      else
        return 0.0;
    };
    return std::max({of(of_body<typename Parts::body>())...});
  }
  /// Returns the warnings of all models, one per line; empty if there are none.
  std::string warning() const {
    std::string all;
    auto const add = [&](auto const& model) {
      if constexpr (requires { model.warning(); }) {
        std::string const text = model.warning();
        all += (all.empty() || text.empty() ? "" : "\n") + text;
      }
    };
    (add(of_body<typename Parts::body>()), ...);
    return all;
  }

 private:
  template <class Body>
  auto filters_of(Resolution const& resolution) const {
    auto const& model = of_body<Body>();
    if constexpr (detail::GivesFilters<model_of<Body>>)
      return only_if(resolution.steps % every_so_many(model.filter_period()) == 0,
                     on_body<Body>(model.filters(resolution)));
    else
      return detail::Tuple<>();
  }
  template <std::size_t K, class OfBodies>
  auto stage_of_all(OfBodies const& of_bodies, Resolution const& resolution) const {
    using Evolved = Merge<typename stage_of<Parts, K>::evolves...>;
    static_assert(
        (std::is_same_v<Common<Evolved, typename Parts::type::evolves>, typename stage_of<Parts, K>::evolves> && ...),
        "models of PhysicsOfBodies evolve the same field in different stages, or fields of a stage in another "
        "order");
    auto const passes = detail::Tuple(bound<typename Parts::body>(
        detail::value_at<K>(detail::value_at<index<typename Parts::body>>(of_bodies)).passes, resolution)...);
    static_assert(are_independent<std::remove_const_t<decltype(passes)>>,
                  "a pass reads of another body what a pass of its model stores in the same stage, so that the result "
                  "would depend on the order of the bodies: store it in an earlier stage");
    return stage<Evolved>(
        detail::with_values([](auto const&... each) { return detail::in_a_row(each...); }, passes),
        detail::in_a_row(bound<typename Parts::body>(
            detail::value_at<K>(detail::value_at<index<typename Parts::body>>(of_bodies)).projections, resolution)...));
  }
  /// Whether no pass of another body reads what the passes of a body write. `Lists` contains the passes of each body.
  template <class Body, class Lists>
  static constexpr bool no_other_reads_it =
      ((std::is_same_v<Body, typename Parts::body> ||
        !detail::read_what_others_store<Body, detail::type_at<index<typename Parts::body>, Lists>,
                                        detail::type_at<index<Body>, Lists>>)&&...);
  template <class Lists>
  static constexpr bool are_independent = (no_other_reads_it<typename Parts::body, Lists> && ...);
  /// Returns the passes of a body with its interface terms with all other bodies.
  template <class Body, class Passes>
  auto bound(Passes const& passes, Resolution const& resolution) const {
    auto const with_all = detail::in_a_row(interface_of<Body, typename Parts::body>(resolution)...);
    return detail::with_values([&](auto const&... each) { return on_body<Body>(passes, each...); }, with_all);
  }
  template <class Body, class Other>
  auto interface_of(Resolution const& resolution) const {
    if constexpr (std::is_same_v<Body, Other>) {
      return detail::Tuple<>();
    } else {
      constexpr bool has_interface = detail::HasInterface<model_of<Body>, model_of<Other>>;
      detail::explain_interface<has_interface>();
      if constexpr (has_interface)
        return detail::Tuple(interface_with<Other>(of_body<Body>().interface_terms(of_body<Other>(), resolution)));
      else
        return detail::Tuple<>();
    }
  }

  std::tuple<typename Parts::type...> models_;
};

}  // namespace scree
