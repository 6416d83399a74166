// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "view.hpp"

#include <span>

// Means over bins of depth along the mid-chord, the line through the axis normal to the surface (figure 17), depths and
// rates that follow from them (a depth that the profile does not reach is NaN), and means over the distance from the
// axis.
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
  std::vector<double> species = {};  ///< concentration of each size of a list
};

struct ProfileQuantity {
  char const* name;
  double ProfileRow::*value;
  char const* unit = "";
};
inline constexpr ProfileQuantity profile_quantities[] = {{"depth", &ProfileRow::depth, "m"},
                                                         {"velocity", &ProfileRow::velocity, "m/s"},
                                                         {"speed", &ProfileRow::speed, "m/s"},
                                                         {"shear_rate", &ProfileRow::shear_rate, "1/s"},
                                                         {"C", &ProfileRow::C},
                                                         {"V", &ProfileRow::V, "m/s"},
                                                         {"D", &ProfileRow::D, "m^2/s"},
                                                         {"gradient_V_rate", &ProfileRow::gradient_V_rate, "1/s"},
                                                         {"gradient_C_rate", &ProfileRow::gradient_C_rate, "1/s"},
                                                         {"diffusion_rate", &ProfileRow::diffusion_rate, "1/s"},
                                                         {"pressure", &ProfileRow::pressure, "Pa"},
                                                         {"shear_stress", &ProfileRow::shear_stress, "Pa"},
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

namespace detail {
/// Adds the concentrations of particle i.
inline void add_species(std::vector<double>& sum, State const& state, std::size_t i) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += state.species[k][i];
}
inline void add_species(std::vector<double>& sum, std::vector<double> const& other) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += other[k];
}
}  // namespace detail

/// Sums over particles, of one state or several.
class MidChord {
 public:
  MidChord() = default;
  /// Takes the concentrations of a number of sizes.
  explicit MidChord(int species) : none_{.species = std::vector<double>(std::size_t(species))} {}

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
    bins_.resize(std::max(bins_.size(), other.bins_.size()), other.none_);
    for (std::size_t k = 0; k < other.bins_.size(); ++k) {
      bins_[k].particles += other.bins_[k].particles;
      for (auto const& q : profile_quantities) bins_[k].*q.value += other.bins_[k].*q.value;
      detail::add_species(bins_[k].species, other.bins_[k].species);
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
      for (double& C : row.species) C /= row.particles;
      row.particles /= samples_;
      profile.rows.push_back(row);
    }
    return profile;
  }

  /// Calls a function with each of the sums, see pack().
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (double* sum : {&samples_, &angle_, &height_, &surface_sum_, &surface_particles_}) visitor(*sum);
    visitor.size(bins_, none_);
    for (ProfileRow& bin : bins_) {
      visitor(bin.particles);
      for (auto const& q : profile_quantities) visitor(bin.*q.value);
      for (double& C : bin.species) visitor(C);
    }
  }

 private:
  void add_particle(State const& state, std::size_t i, Surface const& surface, Drum const& drum) {
    double const depth = surface.depth(state.x[i], state.z[i]);
    if (depth < -drum.spacing || depth > 2 * drum.radius) return;
    double const velocity = surface.along(state.u[i], state.w[i]);
    if (depth < surface_layer(drum)) surface_sum_ += velocity, surface_particles_ += 1;
    auto const bin = static_cast<std::size_t>(std::max(0.0, depth) / drum.spacing);
    if (bin >= bins_.size()) bins_.resize(bin + 1, none_);
    ProfileRow& sum = bins_[bin];
    sum.particles += 1, sum.depth += depth, sum.velocity += velocity;
    sum.speed += std::hypot(state.u[i], state.v.empty() ? 0 : state.v[i], state.w[i]);
    sum.shear_rate += state.shear_rate[i], sum.C += state.C[i], sum.V += state.V[i], sum.D += state.D[i];
    sum.gradient_V_rate += state.gradient_V_rate[i], sum.gradient_C_rate += state.gradient_C_rate[i];
    sum.diffusion_rate += state.diffusion_rate[i], sum.number_density += state.number_density[i];
    detail::add_species(sum.species, state, i);
    sum.pressure += pressure(state, i), sum.shear_stress += shear_stress(state, i);
  }

  double samples_ = 0, angle_ = 0, height_ = 0;
  double surface_sum_ = 0, surface_particles_ = 0;
  ProfileRow none_ = {};          // of an empty bin
  std::vector<ProfileRow> bins_;  // one spacing deep
};

namespace detail {

inline double missing() { return std::numeric_limits<double>::quiet_NaN(); }

/// Depth at which a quantity of the rows first falls to a level, by linear interpolation between the rows.
template <class Value>
double first_below(Profile const& profile, double level, Value const& value) {
  auto const& rows = profile.rows;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    double const above = value(rows[k - 1]) - level, below = value(rows[k]) - level;
    if (above > 0 && below <= 0)
      return rows[k - 1].depth + (rows[k].depth - rows[k - 1].depth) * above / (above - below);
  }
  return missing();
}

}  // namespace detail

/// Velocity minus that of a body that turns with the drum, m/s.
inline double excess(Profile const& profile, ProfileRow const& row, double omega) {
  return row.velocity - omega * (profile.height - row.depth);
}

/// Depth of the rigid body limit, m: below it the excess over rigid rotation is less than 5 % of that of the first row.
inline double active_depth(Profile const& profile, double omega) {
  if (profile.rows.empty()) return detail::missing();
  double const limit = 0.05 * excess(profile, profile.rows.front(), omega);
  return detail::first_below(profile, limit, [&](ProfileRow const& row) { return excess(profile, row, omega); });
}

/// Depth where the velocity along the surface changes its sign, m.
inline double zero_velocity_depth(Profile const& profile) {
  return detail::first_below(profile, 0, [](ProfileRow const& row) { return row.velocity; });
}

/// The row of the largest shear rate; rows must not be empty.
inline ProfileRow const& most_sheared(Profile const& profile) {
  return *std::ranges::max_element(profile.rows, {}, &ProfileRow::shear_rate);
}

/// Mean shear rate in the passive zone, taken from half to nine tenths of the bed depth, 1/s.
inline double passive_shear_rate(Profile const& profile) {
  double sum = 0, particles = 0;
  for (auto const& row : profile.rows) {
    if (row.depth < 0.5 * profile.bed_depth || row.depth > 0.9 * profile.bed_depth) continue;
    sum += row.particles * row.shear_rate, particles += row.particles;
  }
  return sum / particles;
}

/// Depth below which dC/dt from the gradient of V stays under 5 % of its largest magnitude, m; the last tenth of the
/// bed, at the wall, is excluded.
inline double rate_vanishes_at(Profile const& profile) {
  double largest = 0, depth = detail::missing();
  for (auto const& row : profile.rows) largest = std::max(largest, std::abs(row.gradient_V_rate));
  for (auto const& row : profile.rows) {
    if (row.depth < 0.9 * profile.bed_depth && std::abs(row.gradient_V_rate) > 0.05 * largest) depth = row.depth;
  }
  return depth;
}

/// Viscosity of the granular flow at the largest shear rate, Pa s: sqrt(J2) over the shear rate.
inline double granular_viscosity(Profile const& profile) {
  if (profile.rows.empty()) return detail::missing();
  auto const& row = most_sheared(profile);
  return row.shear_stress / row.shear_rate;
}

/// The velocity at a depth, by linear interpolation between the rows.
inline double velocity_at(Profile const& profile, double depth) {
  auto const& rows = profile.rows;
  if (rows.empty()) return detail::missing();
  auto const next = std::ranges::lower_bound(rows, depth, {}, &ProfileRow::depth);
  if (next == rows.begin()) return rows.front().velocity;
  if (next == rows.end()) return rows.back().velocity;
  auto const last = std::prev(next);
  double const part = (depth - last->depth) / (next->depth - last->depth);
  return last->velocity + part * (next->velocity - last->velocity);
}

/// Largest difference between two velocity profiles over the surface speed of the second.
inline double difference(Profile const& a, Profile const& b) {
  double largest = 0;
  for (auto const& row : b.rows) largest = std::max(largest, std::abs(velocity_at(a, row.depth) - row.velocity));
  return largest / std::abs(b.surface_speed);
}

// C over the distance from the axis; rotation alone would not change it.

struct Ring {
  double particles = 0, radius = 0, C = 0, number_density = 0;
  std::vector<double> species = {};  ///< concentration of each size of a list
};

/// Rings a twentieth of the radius wide, at least one spacing; sums of one state or several.
class Rings {
 public:
  Rings() = default;
  /// Takes the concentrations of a number of sizes.
  explicit Rings(int species) : none_{.species = std::vector<double>(std::size_t(species))} {}

  void add(State const& state, Drum const& drum) {
    double const width = std::max(drum.radius / 20, drum.spacing);
    for (std::size_t i : middle(state, drum)) {
      double const radius = std::hypot(state.x[i], state.z[i]);
      auto const ring = static_cast<std::size_t>(radius / width);
      if (ring >= sums_.size()) sums_.resize(ring + 1, none_);
      Ring& sum = sums_[ring];
      sum.particles += 1, sum.radius += radius, sum.C += state.C[i], sum.number_density += state.number_density[i];
      detail::add_species(sum.species, state, i);
    }
  }
  void add(Rings const& other) {
    sums_.resize(std::max(sums_.size(), other.sums_.size()), other.none_);
    for (std::size_t k = 0; k < other.sums_.size(); ++k) {
      sums_[k].particles += other.sums_[k].particles, sums_[k].radius += other.sums_[k].radius;
      sums_[k].C += other.sums_[k].C, sums_[k].number_density += other.sums_[k].number_density;
      detail::add_species(sums_[k].species, other.sums_[k].species);
    }
  }
  /// Without empty rings, outwards.
  std::vector<Ring> mean() const {
    std::vector<Ring> result;
    for (Ring ring : sums_) {
      if (ring.particles == 0) continue;
      ring.radius /= ring.particles, ring.C /= ring.particles, ring.number_density /= ring.particles;
      for (double& C : ring.species) C /= ring.particles;
      result.push_back(ring);
    }
    return result;
  }

  /// Calls a function with each of the sums, see pack().
  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor.size(sums_, none_);
    for (Ring& sum : sums_) {
      for (double* value : {&sum.particles, &sum.radius, &sum.C, &sum.number_density}) visitor(*value);
      for (double& C : sum.species) visitor(C);
    }
  }

 private:
  Ring none_ = {};  // an empty one
  std::vector<Ring> sums_;
};

}  // namespace drum
