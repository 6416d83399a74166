// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A granular bed in a vessel with twenty blades, each with its own motion.
#include <scree/granular/granular.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

namespace {

struct Bed : scree::Formulation<2> {
  using physics = scree::Granular<>;
  using motion = scree::MotionOfGroups<21, scree::Rotation>;
};

}  // namespace

void simulate_bed(std::vector<scree::Vec<2, double>> const& points, scree::Groups<2> const& walls) {
  scree::MotionOfGroups<21, scree::Rotation> motion(walls);
  for (int k = 0; k < walls.count(); ++k) motion.set(k, scree::Rotation{.rate = 0.1 * k});
  scree::Solver<Bed>({.spacing = 0.01, .motion = motion}, points, walls).run(1);
}
