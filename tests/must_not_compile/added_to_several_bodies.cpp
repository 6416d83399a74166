// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: particles are added, removed and let through inlets, drains and open ends only where one body evolves
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/formulation/physics_of_bodies.hpp>
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Clay : scree::MaterialBody {
  static constexpr std::string_view name = "clay";
};
struct Cover : scree::MaterialBody {
  static constexpr std::string_view name = "cover";
};
struct Models : scree::GranularModels {
  using walls = scree::MirrorWalls;
};
using Model = scree::Granular<Models>;
struct Layers : scree::Formulation<2> {
  using bodies = scree::Bodies<Clay, Cover>;
  using physics = scree::PhysicsOfBodies<scree::EvolvedBy<Clay, Model>, scree::EvolvedBy<Cover, Model>>;
};
#ifdef FIXED
void add(scree::Solver<Layers>& solver, std::vector<scree::Vec<2, double>> const&) { solver.step(1); }
#else
void add(scree::Solver<Layers>& solver, std::vector<scree::Vec<2, double>> const& points) { solver.add(points); }
#endif
