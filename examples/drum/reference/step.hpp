// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

namespace grains {

/// One step of one grain: forces at its place, then velocity and place by symplectic Euler.
struct Step {
  State old;
  Column<Place> place;
  Column<Vector> velocity, spin;
  Law law;
  Units units;
  Vector gravity;
  float drum_radius, rotation, step;
  double cosine, sine;  // of the angle of the drum at the end of the step
  int mobile;

  KOKKOS_FUNCTION void operator()(int i) const {
    if (i < mobile)
      move(i);
    else
      turn(i);
  }

  KOKKOS_FUNCTION void turn(int i) const {
    Place p = old.place(i);
    double const x = cosine * old.start_x(i) + sine * old.start_z(i),
                 z = cosine * old.start_z(i) - sine * old.start_x(i);
    p.x = std::int32_t(x / double(units.xz)), p.z = std::int32_t(z / double(units.xz));
    place(i) = p;
    velocity(i) = {float(rotation * z), 0, float(-rotation * x)};
    spin(i) = {0, rotation * p.radius, 0};
  }

  KOKKOS_FUNCTION void move(int i) const {
    Place const p = old.place(i);
    int const n = old.count(i);
    std::uint64_t near = 0;
    for (int s = 0; s < n; ++s) {
      Place const q = old.place(old.neighbour(i, s));
      Vector const d = difference(p, q, units);
      float const reach = p.radius + q.radius;
      if (dot(d, d) < reach * reach) near |= std::uint64_t(1) << s;
    }
    float const m = law.mass_of(p.radius);
    Vector const v = old.velocity(i), w = old.spin(i);
    std::uint64_t const before = old.touching(i);
    Vector sum = m * gravity, turn{};
    for (std::uint64_t left = near; left != 0; left &= left - 1) {
      int const s = Kokkos::Experimental::countr_zero_builtin(static_cast<unsigned long long>(left));
      int const j = old.neighbour(i, s);
      Place const q = old.place(j);
      Vector const d = difference(p, q, units), v_j = old.velocity(j), w_j = old.spin(j);
      Vector spring{};
      if (before >> s & 1) spring = old.spring(i, s);
      float const reach = p.radius + q.radius, distance = Kokkos::sqrt(dot(d, d)), m_j = law.mass_of(q.radius);
      Vector const normal = (1 / distance) * d;
      // arms of the torque, which are shorter than the radii, add up to the distance: angular momentum is conserved
      float const arm = distance / reach;
      Touch const touch{.normal = normal,
                        .overlap = reach - distance,
                        .stiffness = law.modulus * 2 * (p.radius * q.radius) / reach,
                        .effective_mass = m * m_j / (m + m_j),
                        .approach = (v - v_j) - arm * cross(w + w_j, normal)};
      Vector const f = force(law, touch, step, spring);
      sum = sum + f, turn = turn - arm * cross(normal, f);
      old.spring(i, s) = spring;
    }
    if (add_wall(i, p, m, v, w, (before & wall_bit) != 0, sum, turn)) near |= wall_bit;
    old.touching(i) = near;

    Vector const v_new = v + (step / m) * sum;
    float const unit_y = step / units.y, unit = step / units.xz;
    place(i) = {moved(p.x, v_new.x * unit), moved(p.y, v_new.y * unit_y), moved(p.z, v_new.z * unit), p.radius};
    velocity(i) = v_new;
    spin(i) = w + (2.5f * step / m) * turn;
  }

  /// Whether the grain touches the cylinder.
  KOKKOS_FUNCTION bool add_wall(int i, Place const& p, float m, Vector const& v, Vector const& w, bool before,
                                Vector& sum, Vector& turn) const {
    float const x = units.xz * float(p.x), z = units.xz * float(p.z), from_axis = Kokkos::sqrt(x * x + z * z);
    float const overlap = from_axis + p.radius - drum_radius;
    if (!(overlap > 0)) return false;
    Vector const normal{-x / from_axis, 0, -z / from_axis};
    float const arm = (p.radius - overlap) / p.radius;
    Vector const wall{-rotation * drum_radius * normal.z, 0, rotation * drum_radius * normal.x};
    Touch const touch{.normal = normal,
                      .overlap = overlap,
                      .stiffness = law.modulus * 2 * p.radius,
                      .effective_mass = m,
                      .approach = (v - wall) - arm * cross(w, normal)};
    Vector spring{};
    if (before) spring = old.wall_spring(i);
    Vector const f = force(law, touch, step, spring);
    sum = sum + f, turn = turn - arm * cross(normal, f);
    old.wall_spring(i) = spring;
    return true;
  }
};

}  // namespace grains
