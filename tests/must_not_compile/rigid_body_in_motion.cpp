// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: MotionOfBodies lists a rigid body, which moves by the forces on it
#include <scree/granular/granular.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

struct Stone : scree::RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Flow : scree::Formulation<2> {
  using bodies = scree::Bodies<scree::Material, scree::Wall, Stone>;
  using physics = scree::Granular<>;
#ifdef FIXED
  using motion = scree::MotionOfBodies<scree::MovedBy<scree::Wall, scree::Rotation>>;
#else
  using motion = scree::MotionOfBodies<scree::MovedBy<Stone, scree::Rotation>>;
#endif
};
void run(scree::Solver<Flow>& solver) { solver.run(1); }
