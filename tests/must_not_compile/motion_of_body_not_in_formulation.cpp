// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: MotionOfBodies lists a body that is not among the `bodies` of the formulation
#include <scree/granular/granular.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

struct Vessel : scree::WallBody {
  static constexpr std::string_view name = "vessel";
};
struct Flow : scree::Formulation<2> {
  using bodies = scree::Bodies<scree::Material, Vessel>;
  using physics = scree::Granular<>;
#ifdef FIXED
  using motion = scree::MotionOfBodies<scree::MovedBy<Vessel, scree::Rotation>>;
#else
  using motion = scree::MotionOfBodies<scree::MovedBy<scree::Wall, scree::Rotation>>;  // it would not move the vessel
#endif
};

double run(scree::Solver<Flow>& solver) { return solver.time(); }
