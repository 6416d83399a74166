// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "lists.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grains {

/// Mean and largest overlap, over the diameter of the smaller grain, and the number of contacts of a grain.
struct Overlaps {
  double mean = 0, largest = 0, contacts = 0;
};

class Bed {
 public:
  Bed(Settings settings, std::vector<Grain> const& grains);

  /// Advances by a number of steps.
  void advance(long steps);
  void set_rotation(double rotation) { settings_.rotation = rotation; }

  /// In the order in which they were given.
  std::vector<Grain> grains() const;
  Overlaps overlaps() const;
  double kinetic_energy() const;  ///< of the grains that move, all replicas, J

  Settings const& settings() const { return settings_; }
  double time() const { return double(steps_) * settings_.step; }
  long steps() const { return steps_; }
  long rebuilds() const { return rebuilds_; }
  /// Looks at the lists that found a grain further from its place in them than half the skin.
  long late_rebuilds() const { return late_; }
  int mobile() const { return mobile_; }
  int size() const { return size_; }
  /// The first grain of each kind, and their number.
  std::array<int, max_kinds + 1> const& first() const { return first_; }
  State const& state() const { return now_; }
  Units const& units() const { return units_; }

 private:
  void rebuild();
  double farthest(double ahead) const;  // largest displacement since the last rebuild, after `ahead` more seconds

  Settings settings_;
  Law law_;
  Units units_;
  int size_ = 0, mobile_ = 0, kinds_ = 0;
  std::array<int, max_kinds + 1> first_ = {};
  State now_, other_;
  Lists lists_;
  long steps_ = 0, rebuilds_ = 0, late_ = 0;
  double angle_ = 0;
};

inline Bed::Bed(Settings settings, std::vector<Grain> const& grains)
    : settings_(std::move(settings)), law_(settings_.material) {
  auto const& o = settings_;
  kinds_ = int(o.kinds.size());
  if (kinds_ < 1 || kinds_ > max_kinds) throw std::runtime_error("a bed has one to four kinds of grains");
  if (o.replicas < 1 || o.replicas > 255) throw std::runtime_error("a bed has 1 to 255 replicas");
  for (double positive : {o.length, o.range, o.step, o.skin, o.drum_radius})
    if (!(positive > 0)) throw std::runtime_error("length, range, step, skin and drum radius must be positive");
  if (o.drum_radius >= o.range) throw std::runtime_error("the range must be larger than the radius of the drum");
  units_ = {float(o.range / 2147483648.0), float(o.length / 4294967296.0)};
  size_ = int(grains.size());
  now_ = State(size_), other_ = State(size_);

  for (int kind = 0; kind < kinds_; ++kind) {
    if (kind > 0 && o.kinds[kind - 1].glued && !o.kinds[kind].glued) throw std::runtime_error("glued kinds come last");
    first_[kind + 1] = first_[kind] + int(std::ranges::count(grains, kind, &Grain::kind));
    if (!o.kinds[kind].glued) mobile_ = first_[kind + 1];
  }
  std::fill(first_.begin() + kinds_ + 1, first_.end(), size_);
  if (first_[kinds_] != size_) throw std::runtime_error("a grain has a kind that the bed does not have");
  double glued_from = o.range;
  for (Grain const& g : grains)
    if (o.kinds[g.kind].glued) glued_from = std::min(glued_from, std::hypot(g.x[0], g.x[2]));
  lists_ = Lists(o, first_, units_, glued_from);
  auto const place = Kokkos::create_mirror_view(now_.place);
  auto const velocity = Kokkos::create_mirror_view(now_.velocity), spin = Kokkos::create_mirror_view(now_.spin);
  auto const replica = Kokkos::create_mirror_view(now_.replica);
  auto const identity = Kokkos::create_mirror_view(now_.identity);
  auto const start_x = Kokkos::create_mirror_view(now_.start_x), start_z = Kokkos::create_mirror_view(now_.start_z);
  auto next = first_;
  for (int k = 0; k < size_; ++k) {
    Grain const& g = grains[k];
    if (std::abs(g.x[0]) >= o.range || std::abs(g.x[2]) >= o.range || g.replica < 0 || g.replica >= o.replicas)
      throw std::runtime_error("grain " + std::to_string(k) +
                               " is out of the range, or of a replica that the bed does not have");
    int const i = next[g.kind]++;
    double const y = g.x[1] / o.length, radius = o.kinds[g.kind].radius;
    place(i) = {std::int32_t(g.x[0] / double(units_.xz)),
                std::int32_t(std::uint32_t(std::int64_t((y - std::floor(y)) * 4294967296.0))),
                std::int32_t(g.x[2] / double(units_.xz)), float(radius)};
    velocity(i) = {float(g.v[0]), float(g.v[1]), float(g.v[2])};
    spin(i) = {float(radius * g.spin[0]), float(radius * g.spin[1]), float(radius * g.spin[2])};
    replica(i) = std::uint8_t(g.replica), identity(i) = k;
    start_x(i) = g.x[0], start_z(i) = g.x[2];
  }
  Kokkos::deep_copy(now_.place, place), Kokkos::deep_copy(now_.velocity, velocity), Kokkos::deep_copy(now_.spin, spin);
  Kokkos::deep_copy(now_.replica, replica), Kokkos::deep_copy(now_.identity, identity);
  Kokkos::deep_copy(now_.start_x, start_x), Kokkos::deep_copy(now_.start_z, start_z);
  rebuild();
}

inline void Bed::advance(long steps) {
  auto const& o = settings_;
  Vector const gravity{float(o.gravity[0]), float(o.gravity[1]), float(o.gravity[2])};
  for (long k = 0; k < steps; ++k) {
    angle_ += o.rotation * o.step;
    Step const step{.old = now_,
                    .place = other_.place,
                    .velocity = other_.velocity,
                    .spin = other_.spin,
                    .law = law_,
                    .units = units_,
                    .gravity = gravity,
                    .drum_radius = float(o.drum_radius),
                    .rotation = float(o.rotation),
                    .step = float(o.step),
                    .cosine = std::cos(angle_),
                    .sine = std::sin(angle_),
                    .mobile = mobile_};
    // with 64 registers a thread, more threads fit and hide the waiting for neighbours
    Kokkos::parallel_for("step", Kokkos::RangePolicy<Space, Kokkos::LaunchBounds<128, 8>>(0, size_), step);
    std::swap(now_.place, other_.place);
    std::swap(now_.velocity, other_.velocity);
    std::swap(now_.spin, other_.spin);
    ++steps_;
    if (steps_ % o.check_every != 0) continue;
    if (farthest(o.check_every * o.step) > 0.5 * o.skin) {
      if (farthest(0) > 0.5 * o.skin) ++late_;
      rebuild();
    }
  }
}

inline void Bed::rebuild() {
  lists_.rebuild(now_, other_);
  std::swap(now_, other_);
  ++rebuilds_;
}

namespace detail {

inline double farthest(Column<Place> place, Column<Place> listed, Column<Vector> velocity, Units units, float time) {
  float largest = 0;
  Kokkos::parallel_reduce(
      "farthest", Kokkos::RangePolicy<Space>(0, int(place.extent(0))),
      KOKKOS_LAMBDA(int i, float& most) {
        Vector const d = difference(place(i), listed(i), units), v = velocity(i);
        float const there = Kokkos::sqrt(dot(d, d)) + time * Kokkos::sqrt(dot(v, v));
        if (!(there <= most)) most = there;
      },
      Kokkos::Max<float>(largest));
  return largest;
}

}  // namespace detail

inline double Bed::farthest(double ahead) const {
  return detail::farthest(now_.place, lists_.listed, now_.velocity, units_, float(ahead));
}

inline std::vector<Grain> Bed::grains() const {
  auto const place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), now_.place);
  auto const velocity = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), now_.velocity);
  auto const spin = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), now_.spin);
  auto const replica = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), now_.replica);
  auto const identity = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), now_.identity);
  std::vector<Grain> result(size_);
  for (int kind = 0; kind < kinds_; ++kind) {
    for (int i = first_[kind]; i < first_[kind + 1]; ++i) {
      Place const& p = place(i);
      double const r = p.radius;
      result[identity(i)] =
          Grain{.x = {double(units_.xz) * p.x, double(units_.y) * double(std::uint32_t(p.y)), double(units_.xz) * p.z},
                .v = {velocity(i).x, velocity(i).y, velocity(i).z},
                .spin = {spin(i).x / r, spin(i).y / r, spin(i).z / r},
                .kind = kind,
                .replica = replica(i)};
    }
  }
  return result;
}

inline double Bed::kinetic_energy() const {
  double sum = 0;
  auto const state = now_;
  auto const law = law_;
  Kokkos::parallel_reduce(
      "kinetic_energy", Kokkos::RangePolicy<Space>(0, mobile_),
      KOKKOS_LAMBDA(int i, double& all) {
        Vector const v = state.velocity(i), w = state.spin(i);
        all += 0.5 * double(law.mass_of(state.place(i).radius)) * double(dot(v, v) + 0.4f * dot(w, w));
      },
      sum);
  return sum;
}

inline Overlaps Bed::overlaps() const {
  double sum = 0, largest = 0, contacts = 0;
  auto const state = now_;
  auto const units = units_;
  Kokkos::parallel_reduce(
      "overlaps", Kokkos::RangePolicy<Space>(0, mobile_),
      KOKKOS_LAMBDA(int i, double& all, double& most, double& number) {
        Place const p = state.place(i);
        for (int s = 0; s < state.count(i); ++s) {
          Place const q = state.place(state.neighbour(i, s));
          Vector const d = difference(p, q, units);
          double const overlap =
              double((p.radius + q.radius - Kokkos::sqrt(dot(d, d))) / (2 * Kokkos::fmin(p.radius, q.radius)));
          if (!(overlap > 0)) continue;
          all += overlap, number += 1;
          if (overlap > most) most = overlap;
        }
      },
      sum, Kokkos::Max<double>(largest), contacts);
  return {.mean = sum / std::max(1.0, contacts), .largest = largest, .contacts = contacts / std::max(1, mobile_)};
}

}  // namespace grains
