// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/rate.hpp"
#include "../passes/pass.hpp"
#include "../passes/stage.hpp"
#include "../terms/xsph.hpp"

#include <tuple>
#include <type_traits>

// The velocity with which particles of a material move. An advection model names the entry of the position in `evolves`
// and returns the stages that evolve velocity and position, given the passes that compute the acceleration.
namespace scree {

/// An advection scheme, which chooses the velocity that moves particles, is a struct with these members:
///   position                   the entry of the position in `evolves`: Position, or Evolves<Position, ...>
///   stages(rho, passes)        tuple of stages that evolve velocity and position; `passes` compute the acceleration
template <class A>
concept AdvectionScheme = requires(A const& advection, UniformDensity const& rho) {
  typename A::position;
  requires std::is_same_v<detail::evolved_field<typename A::position>, Position>;
  std::tuple_size<decltype(advection.stages(rho, std::tuple<>()))>::value;
};

/// Advection scheme in which particles move with their own velocity.
struct OwnVelocity {
  using position = Position;
  template <class Rho, class Passes>
  auto stages(Rho const&, Passes const& acceleration_passes) const {
    return std::tuple(stage<Fields<Velocity, Position>>(acceleration_passes));
  }
};

/// Advection scheme in which particles move with a velocity between their own and the mean of their neighbours, see
/// terms/xsph.hpp. Xsph cannot be combined with VelocityVerlet, which moves particles with their own velocity.
struct Xsph {
  double epsilon = 0.5;

  using position = Evolves<Position, TransportVelocity>;
  static constexpr auto parameters() {
    return std::array{parameter("epsilon", &Xsph::epsilon, "1", "0: own velocity, 1: mean of the surroundings",
                                allowed::from_to(0, 1))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "Xsph"); }
  template <class Rho, class Passes>
  auto stages(Rho const& rho, Passes const& acceleration_passes) const {
    auto const mix = pair_pass_then<Material>("scree::transport_velocity", MixVelocity{epsilon},
                                              over<Material>(MeanVelocityDifference<Rho>{rho}));
    return std::tuple(stage<Fields<Velocity>>(acceleration_passes), stage<Fields<position>>(std::tuple(mix)));
  }
};

}  // namespace scree
