// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/confines.hpp"
#include "../formulation/formulation.hpp"
#include "../motion/prescribe.hpp"

#include <type_traits>
#include <vector>

namespace scree::detail {

/// The bodies of a formulation that follow its motion.
template <class P>
class Followers {
 public:
  using Basis = basis_of<P>;
  using vector = Vec<P::dim, typename P::real>;
  using Motion = typename P::motion;
  using All = typename P::bodies;
  using Prescribed = not_rigid_among<following_bodies<P>>;

  explicit Followers(std::vector<Period> const& periods) : confines_(periods) {}

  Confines<Basis, All::count>& confines() { return confines_; }
  Confines<Basis, All::count> const& confines() const { return confines_; }

  /// Adds the positions at time zero of the particles of a body on this rank.
  template <class Body, class Sys>
  void add(Sys const& system, Motion const& motion, std::vector<vector> const& points) {
    auto const whole = system.template whole<Body>();
    auto const parts = parts_that_move(motion_of_body<Body>(motion), whole.here(), points);
    std::vector<std::vector<vector>> corners;
    for (auto const& part : parts) corners.push_back(whole.all_of(corners_of(part)));
    confines_.add_wall(body_index<Body, All>(), corners);
    if constexpr (Carries<Body>::any) some_.template of<Body>() = SomeOfBody<P::dim>(parts, whole);
  }
  /// Adds the positions of the particles of a material whose position does not evolve.
  template <class Sys>
  void add_material(Sys const& system, Motion const& motion, std::vector<vector> const& points) {
    if constexpr (!evolves_position<P> && Carries<Material>::any)
      some_.template of<Material>() = SomeOfBody<P::dim>(
          parts_that_move(motion_of_body<Material>(motion), system.template body<Material>(), points),
          system.template whole<Material>());
  }
  /// Throws std::invalid_argument if a body needs the velocity gradient of a motion whose velocity is not affine over
  /// that body at a time (s).
  void check(Motion const& motion, double time) const {
    for_each_body(Prescribed{}, [&]<class Body>() {
      if constexpr (Carries<Body>::gradient)
        some_.template of<Body>().check_gradient(motion_of_body<Body>(motion), time);
    });
  }
  /// Throws std::invalid_argument if the functions of the motion of a body contradict each other between two times (s).
  /// Only the functions for fields that the body carries are checked.
  [[gnu::cold]] void check_paths(Motion const& motion, double from, double to) const {
    for_each_body(All{}, [&]<class Body>() {
      if constexpr (Carries<Body>::any && !RigidTag<Body>)
        some_.template of<Body>().check_paths(motion_of_body<Body>(motion), from, to, Carries<Body>::acceleration);
    });
  }
  /// Moves all bodies to their positions at a time (s). A material whose position does not evolve gets the velocity of
  /// its motion.
  template <class Sys>
  static void move(Sys& system, Motion const& motion, double time) {
    for_each_body(Prescribed{}, [&]<class Body>() { move<Body>(system, motion, time); });
    using OfMaterial = Common<Fields<Velocity>, material_fields<P>>;
    if constexpr (!evolves_position<P> && !std::is_same_v<OfMaterial, Fields<>>)
      for_each_particle<Basis>(
          "scree::prescribe", system.template body<Material>(),
          Kinematics<body_motion<P, Material>, OfMaterial>{motion_of_body<Material>(motion), time});
  }
  /// Updates the material by a function, then moves all bodies as move() does. The first body moves in the same sweep,
  /// which saves a kernel launch on a GPU.
  template <class Sys, class Function>
  static void update_and_move(Sys& system, Function const& function, Motion const& motion, double time) {
    update_and_move(system, function, motion, time, Prescribed{});
  }
  /// Returns the box around all bodies at a time (s).
  DistanceBeyond<vector> box(Motion const& motion, double time) const {
    return [&]<class... Bs>(Bodies<Bs...>) { return confines_.at(time, motion_of_body<Bs>(motion)...); }(All{});
  }
  /// Returns the largest absolute coordinate (m) among walls at time zero, walls at a time (s), and the positions given
  /// to the material.
  double farthest(Motion const& motion, double time) const {
    return [&]<class... Bs>(Bodies<Bs...>) { return confines_.farthest(time, motion_of_body<Bs>(motion)...); }(All{});
  }

 private:
  /// The kinematic fields that a body carries; none for a body at rest, whose values cannot be wrong.
  template <class Body>
  struct Carries {
    static constexpr bool moves = !std::is_same_v<body_motion<P, Body>, AtRest>;
    using fields = std::conditional_t<moves, scree::carried_fields<P, Body>, Fields<>>;
    static constexpr bool gradient = OneOf<VelocityGradient, fields>, acceleration = OneOf<Acceleration, fields>;
    static constexpr bool any = gradient || acceleration || OneOf<Velocity, fields>;
  };
  template <class Body>
  static auto place_at(Motion const& motion, double time) {
    using Given = Common<Fields<Velocity, Acceleration, VelocityGradient>, scree::carried_fields<P, Body>>;
    return Place<body_motion<P, Body>, Given>{motion_of_body<Body>(motion), time};
  }
  template <class Body, class Sys>
  static void move(Sys& system, Motion const& motion, double time) {
    auto const& body = system.template body<Body>();
    if (body.size() > 0) for_each_particle<Basis>("scree::move_wall", body, place_at<Body>(motion, time));
  }
  template <class Sys, class Function, class... Walls>
  static void update_and_move(Sys& system, Function const& function, Motion const& motion, double time,
                              Bodies<Walls...>) {
    auto const& material = system.template body<Material>();
    if constexpr (sizeof...(Walls) == 0)
      for_each_particle<Basis>("scree::update", material, function);
    else
      [&]<class First, class... Others>(Bodies<First, Others...>) {
        for_each_particle_of_two<Basis>("scree::update", material, function, system.template body<First>(),
                                        place_at<First>(motion, time));
        (move<Others>(system, motion, time), ...);
      }(Bodies<Walls...>{});
  }

  Confines<Basis, All::count> confines_;
  PerBody<SomeOfBody<P::dim>, All> some_;  // of bodies that carry fields which their motion gives
};

}  // namespace scree::detail
