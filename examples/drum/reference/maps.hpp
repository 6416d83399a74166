// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "bed.hpp"
#include "filling.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace grains {

/// Sums of grains in the columns of a square grid across the drum, for each replica: of volumes, volumes times
/// velocity.
class Maps {
 public:
  /// In the order in which values() has them: solid volume of large and small grains, m^3; its momenta along x and z
  /// over the density; sum of volume times squared speed.
  static constexpr int fields = 7;

  /// Values of the first `kept` fields are returned.
  Maps(double range, double cell, int replicas, int kept = fields)
      : cell_(cell),
        kept_(kept),
        across_(2 * int(std::ceil(range / cell))),
        replicas_(replicas),
        sums_("sums", std::size_t(replicas) * fields * across_ * across_) {}

  int across() const { return across_; }
  double cell() const { return cell_; }

  void add(Bed const& bed) {
    auto const state = bed.state();
    auto const units = bed.units();
    auto const sums = sums_;
    int const across = across_, first_small = bed.first()[small];
    float const per_cell = float(1 / cell_);
    Kokkos::parallel_for(
        "maps", Kokkos::RangePolicy<Space>(0, bed.mobile()), KOKKOS_LAMBDA(int i) {
          Place const p = state.place(i);
          int const x = int(Kokkos::floor(units.xz * float(p.x) * per_cell)) + across / 2;
          int const z = int(Kokkos::floor(units.xz * float(p.z) * per_cell)) + across / 2;
          if (x < 0 || x >= across || z < 0 || z >= across) return;
          double const volume = 4 * std::numbers::pi / 3 * double(p.radius) * double(p.radius) * double(p.radius);
          Vector const v = state.velocity(i);
          int const kind = i < first_small ? 0 : 1;
          auto const at = [&](int field) {
            return &sums(((std::size_t(state.replica(i)) * fields + field) * across + z) * across + x);
          };
          Kokkos::atomic_add(at(kind), volume);
          Kokkos::atomic_add(at(2 + kind), volume * double(v.x));
          Kokkos::atomic_add(at(4 + kind), volume * double(v.z));
          Kokkos::atomic_add(at(6), volume * double(dot(v, v)));
        });
    ++samples_;
  }

  /// Means over the samples since the last call: replica, field, z, x.
  std::vector<float> take() {
    auto const sums = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), sums_);
    std::vector<float> result;
    std::size_t const of_field = std::size_t(across_) * across_;
    for (std::size_t k = 0; k < sums.extent(0); ++k)
      if (int(k / of_field % fields) < kept_) result.push_back(float(sums(k) / std::max(1, samples_)));
    Kokkos::deep_copy(sums_, 0.0);
    samples_ = 0;
    return result;
  }
  int samples() const { return samples_; }

 private:
  double cell_;
  int kept_, across_, replicas_, samples_ = 0;
  Column<double> sums_;
};

/// Number of grains whose centres are further from the axis than the wall's tips, and of those that left the drum.
struct Losses {
  long in_wall = 0, lost = 0;
};
inline Losses losses(Bed const& bed, double inner, double outer) {
  auto const state = bed.state();
  auto const units = bed.units();
  Losses result;
  Kokkos::parallel_reduce(
      "losses", Kokkos::RangePolicy<Space>(0, bed.mobile()),
      KOKKOS_LAMBDA(int i, long& in_wall, long& lost) {
        Place const p = state.place(i);
        double const x = double(units.xz) * p.x, z = double(units.xz) * p.z, r = Kokkos::sqrt(x * x + z * z);
        if (r > inner) ++in_wall;
        if (!(r < outer)) ++lost;
      },
      result.in_wall, result.lost);
  return result;
}

}  // namespace grains
