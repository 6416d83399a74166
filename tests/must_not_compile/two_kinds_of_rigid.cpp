// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: each group of its particles is a rigid body of its own
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Stone : scree::RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Brick : scree::RigidBody {
  static constexpr std::string_view name = "brick";
};
struct Flow : scree::Formulation<2> {
#ifdef FIXED
  using bodies = scree::Bodies<scree::Material, scree::Wall, Stone>;
#else
  using bodies = scree::Bodies<scree::Material, scree::Wall, Stone, Brick>;
#endif
  using physics = scree::Granular<>;
};
void run(scree::Solver<Flow>& solver) { solver.run(1); }
