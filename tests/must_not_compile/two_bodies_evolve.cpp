// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: where several bodies evolve, `physics` has a model for each of them
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
#ifdef FIXED
  using physics = scree::PhysicsOfBodies<scree::EvolvedBy<Clay, Model>, scree::EvolvedBy<Cover, Model>>;
#else
  using physics = Model;
#endif
};
using Advanced = scree::Solver<Layers>;
double advance(Advanced& solver) { return solver.step(1); }
