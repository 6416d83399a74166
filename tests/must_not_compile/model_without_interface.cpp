// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a model of PhysicsOfBodies needs a function interface_terms
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/formulation/combined.hpp>
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
struct Warm {
  using evolves = scree::Fields<>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};
#ifdef FIXED
using OfClay = Model;
#else
using OfClay = scree::Combined<Model, Warm>;
#endif
struct Layers : scree::Formulation<2> {
  using bodies = scree::Bodies<Clay, Cover>;
  using physics = scree::PhysicsOfBodies<scree::EvolvedBy<Clay, OfClay>, scree::EvolvedBy<Cover, Model>>;
};
using Advanced = scree::Solver<Layers>;
double advance(Advanced& solver) { return solver.step(1); }
