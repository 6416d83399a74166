// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/law.hpp"
#include "strain.hpp"
#include "volume_control.hpp"

// Quantities that bound the validity of a granular model.
namespace scree::granular {

/// Computes the speed of sound at a particle, m/s, for a law of constant stiffness.
struct ConstantSpeed {
  double speed;
  using reads = Fields<>;
  template <class I>
  SCREE_FN double operator()(I const&) const {
    return speed;
  }
};
/// Computes the speed of sound at a particle, m/s, for any law.
template <class Law>
struct SpeedOfState {
  Law law;
  using reads = Merge<Fields<Stress>, point_of<Law>>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(sound_speed_at(law, unpacked(i[fields::stress]), i));
  }
};

/// Computes the Mach number of a particle: its speed over the speed of sound.
template <class SoundSpeed>
struct MachNumber {
  SoundSpeed sound_speed;
  using reads = Merge<Fields<Velocity>, reads_of<SoundSpeed>>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(norm(i[fields::velocity])) / sound_speed(i);
  }
};

/// Computes the number density of a particle over the number density at rest.
struct NumberRatio {
  double at_rest;
  using reads = Fields<NumberDensity>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(i[fields::number_density]) / at_rest;
  }
};

}  // namespace scree::granular
