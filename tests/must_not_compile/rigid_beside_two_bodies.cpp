// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a formulation with a body that derives from RigidBody has one body that evolves
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
struct Stone : scree::RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Layers : scree::Formulation<2> {
#ifdef FIXED
  using bodies = scree::Bodies<Clay, Cover>;
#else
  using bodies = scree::Bodies<Clay, Cover, Stone>;
#endif
  using physics = scree::PhysicsOfBodies<scree::EvolvedBy<Clay, Model>, scree::EvolvedBy<Cover, Model>>;
};
using Advanced = scree::Solver<Layers>;
double advance(Advanced& solver) { return solver.step(1); }
