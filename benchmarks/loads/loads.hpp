// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../step/box.hpp"

#include <scree/openings/regions.hpp>
#include <scree/rigid/measured_mass.hpp>

// The box of step/box.hpp alone, with grains that come and go, and with a rigid block on the bed.
namespace scree::bench {

struct Block : RigidBody {
  static constexpr std::string_view name = "block";
};
template <int Dim, class Real>
struct LoadedBox : GranularBox<Dim, Real> {
  using bodies = Bodies<Material, Wall, Block>;
};

/// Grains rain onto 0.4 m of the bed along each axis, three spacings above it, as fast as the bed moves there, a
/// fiftieth of full layers, and leave through 0.1 m of the floor along each axis. Lists last as long as without them.
template <class F>
Solver<F> open_box(BoxCase const& wanted) {
  static constexpr int dim = F::dim;
  Solver<F> solver = box<F>(wanted);
  double const dr = solver.settings().spacing;
  using X = Vec<dim, double>;
  auto const area = [&](double edge, double low, double high) {
    Box<dim> slab{X::Constant(0.5 - edge / 2), X::Constant(0.5 + edge / 2)};
    slab.low[dim - 1] = low, slab.high[dim - 1] = high;
    return slab;
  };
  X down = X::Zero();
  down[dim - 1] = -wanted.shear;
  auto const layer = fill_lattice(area(0.4, 1 + 3 * dr, 1 + 4 * dr), dr);
  solver.feed({.name = "rain",
               .layer = layer,
               .velocity = down,
               .pushes = false,
               .rate = 0.02 * wanted.shear * double(layer.size()) * std::pow(dr, dim - 1)});
  auto const hole = area(0.1, -3 * dr, dr / 2);
  solver.drain({.name = "hole"}, Within<dim>{hole.low, hole.high});
  return solver;
}

/// A box whose bed carries a block, 0.2 m wide along each axis and 0.1 m high. The block starts with the velocity of
/// the surface.
template <class F>
Solver<F> loaded_box(BoxCase const& wanted) {
  static constexpr int dim = F::dim;
  using Real = typename F::real;
  auto const points = points_of<dim>(wanted);
  Box<dim> block{Vec<dim, double>::Constant(0.4), Vec<dim, double>::Constant(0.6)};
  block.low[dim - 1] = 1, block.high[dim - 1] = 1.1;
  SolverSettings<F> settings{.spacing = points.spacing, .physics = physics_of<F>()};
  auto& stone =
      settings.rigid.bodies.emplace_back(Rigid<dim>{.properties = mass_properties(block, 2500, points.spacing)});
  stone.velocity[0] = wanted.shear;
  Solver<F> solver(settings, particles_of<Material>(cast<Real>(points.inside)),
                   particles_of<Wall>(cast<Real>(points.wall)),
                   particles_of<Block>(cast<Real>(fill_lattice(block, points.spacing))));
  start(solver, wanted);
  return solver;
}

/// 120 steps at a time: with a million particles, a layer comes in each.
template <int Dim, class Real>
int add_load_rows() {
  using Alone = GranularBox<Dim, Real>;
  using Loaded = LoadedBox<Dim, Real>;
  int const steps = 120;
  for (int const particles : sizes<Alone>()) {
    auto const name = [&](char const* who) {
      return fmt::format("step/loads/{}/{}/particles:{}", who, basis_name<Alone>(), particles);
    };
    BoxCase const wanted{.particles = double(particles)};  // 0.5 m/s at the surface
    add_step_row(name("none"), steps, steps, [=] { return box<Alone>(wanted); });
    add_step_row(name("inlet_and_drain"), steps, steps, [=] { return open_box<Alone>(wanted); });
    add_step_row(name("rigid_block"), steps, steps, [=] { return loaded_box<Loaded>(wanted); });
    add_phases_row(name("none/phases"), steps, [=] { return box<Alone>(wanted); });
    add_phases_row(name("rigid_block/phases"), steps, [=] { return loaded_box<Loaded>(wanted); });
  }
  return 0;
}

}  // namespace scree::bench
