// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "surface.hpp"

#include <span>

// Means over bins of depth along the mid-chord, the line through the axis normal to the surface (figure 17).
namespace drum {

/// Means over the particles of one bin, SI units.
struct ProfileRow {
  double particles = 0;  ///< in the bin, per sample
  double depth = 0;      ///< mean of its particles
  double velocity = 0;   ///< along the surface, downhill
  double speed = 0;
  double shear_rate = 0, C = 0, V = 0, D = 0;
  double gradient_V_rate = 0, gradient_C_rate = 0, diffusion_rate = 0;
  double pressure = 0, shear_stress = 0, number_density = 0;
};

struct ProfileQuantity {
  char const* name;
  double ProfileRow::*value;
};
inline constexpr ProfileQuantity profile_quantities[] = {{"depth", &ProfileRow::depth},
                                                         {"velocity", &ProfileRow::velocity},
                                                         {"speed", &ProfileRow::speed},
                                                         {"shear_rate", &ProfileRow::shear_rate},
                                                         {"C", &ProfileRow::C},
                                                         {"V", &ProfileRow::V},
                                                         {"D", &ProfileRow::D},
                                                         {"gradient_V_rate", &ProfileRow::gradient_V_rate},
                                                         {"gradient_C_rate", &ProfileRow::gradient_C_rate},
                                                         {"diffusion_rate", &ProfileRow::diffusion_rate},
                                                         {"pressure", &ProfileRow::pressure},
                                                         {"shear_stress", &ProfileRow::shear_stress},
                                                         {"number_density", &ProfileRow::number_density}};

struct Profile {
  double time = 0;                    ///< s
  double samples = 0;                 ///< states averaged
  double angle = 0;                   ///< degrees
  double height = 0;                  ///< m, of the surface over the axis along its normal
  double bed_depth = 0;               ///< m
  double surface_speed = 0;           ///< m/s, mean of `velocity` over surface_layer()
  std::vector<ProfileRow> rows = {};  ///< downwards; without empty bins
};

/// Half the width of the strip around the mid-chord, m.
inline double strip(Drum const& drum) { return std::max(0.1 * drum.radius, 2 * drum.spacing); }
/// Depth of the surface layer, m: 1 mm, or one particle spacing if that is larger.
inline double surface_layer(Drum const& drum) { return std::max(1e-3, drum.spacing); }

/// Sums over particles, of one state or several.
class MidChord {
 public:
  void add(State const& state, Surface const& surface, Drum const& drum) {
    if (std::isnan(surface.angle)) return;
    samples_ += 1, angle_ += surface.angle, height_ += surface.height;
    for (std::size_t i : middle(state, drum)) {
      if (std::abs(surface.s(state.x[i], state.z[i])) > strip(drum)) continue;
      add_particle(state, i, surface, drum);
    }
  }

  void add(MidChord const& other) {
    samples_ += other.samples_, angle_ += other.angle_, height_ += other.height_;
    surface_sum_ += other.surface_sum_, surface_particles_ += other.surface_particles_;
    bins_.resize(std::max(bins_.size(), other.bins_.size()));
    for (std::size_t k = 0; k < other.bins_.size(); ++k) {
      bins_[k].particles += other.bins_[k].particles;
      for (auto const& q : profile_quantities) bins_[k].*q.value += other.bins_[k].*q.value;
    }
  }

  Profile mean(double time, Drum const& drum) const {
    Profile profile{.time = time,
                    .samples = samples_,
                    .angle = angle_ / samples_ * 180 / std::numbers::pi,
                    .height = height_ / samples_,
                    .bed_depth = drum.radius + height_ / samples_,
                    .surface_speed = surface_sum_ / surface_particles_};
    for (ProfileRow row : bins_) {
      if (row.particles == 0) continue;
      for (auto const& q : profile_quantities) row.*q.value /= row.particles;
      row.particles /= samples_;
      profile.rows.push_back(row);
    }
    return profile;
  }

  /// Calls a function with each of the sums, see pack().
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (double* sum : {&samples_, &angle_, &height_, &surface_sum_, &surface_particles_}) visitor(*sum);
    visitor.size(bins_);
    for (ProfileRow& bin : bins_) {
      visitor(bin.particles);
      for (auto const& q : profile_quantities) visitor(bin.*q.value);
    }
  }

 private:
  void add_particle(State const& state, std::size_t i, Surface const& surface, Drum const& drum) {
    double const depth = surface.depth(state.x[i], state.z[i]);
    if (depth < -drum.spacing || depth > 2 * drum.radius) return;
    double const velocity = surface.along(state.u[i], state.w[i]);
    if (depth < surface_layer(drum)) surface_sum_ += velocity, surface_particles_ += 1;
    auto const bin = static_cast<std::size_t>(std::max(0.0, depth) / drum.spacing);
    if (bin >= bins_.size()) bins_.resize(bin + 1);
    ProfileRow& sum = bins_[bin];
    sum.particles += 1, sum.depth += depth, sum.velocity += velocity;
    sum.speed += std::hypot(state.u[i], state.v.empty() ? 0 : state.v[i], state.w[i]);
    sum.shear_rate += state.shear_rate[i], sum.C += state.C[i], sum.V += state.V[i], sum.D += state.D[i];
    sum.gradient_V_rate += state.gradient_V_rate[i], sum.gradient_C_rate += state.gradient_C_rate[i];
    sum.diffusion_rate += state.diffusion_rate[i], sum.number_density += state.number_density[i];
    sum.pressure += pressure(state, i), sum.shear_stress += shear_stress(state, i);
  }

  double samples_ = 0, angle_ = 0, height_ = 0;
  double surface_sum_ = 0, surface_particles_ = 0;
  std::vector<ProfileRow> bins_;  // one spacing deep
};

}  // namespace drum
