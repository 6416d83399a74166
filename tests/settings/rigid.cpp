// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/rigid/settings.hpp>

#include <settings/range.hpp>

// Every parameter of rigid bodies, with the ends of its range.
namespace scree::test::rigid_tests {

TEST_CASE("settings: contact of rigid bodies") {
  RigidContact const contact;
  range(contact, OF(modulus), "modulus (Pa) of RigidContact", "0 or more", {0, huge}, {-1, inf});
  range(contact, OF(restitution), "restitution (-) of RigidContact", "0 to 1", {0, 1}, {-tiny, 1.01});
  range(contact, OF(friction), "friction (-) of RigidContact", "0 or more", {0, huge}, {-0.1, inf});
  range(contact, OF(damped_below), "damped_below (m/s) of RigidContact", "0 or more", {0, huge}, {-1, inf});
  range(contact, OF(largest_overlap), "largest_overlap (-) of RigidContact", "above 0", {tiny, inf}, {0, -1});
}

TEST_CASE("settings: rigid bodies") {
  Rigid<2> body;
  body.properties = {2, {0, 0}, Inertia<2>::Constant(1)};
  Spring<2> spring{.stiffness = 10};
  spring.other = 1;
  RigidBodies<2> const rigid{.bodies = {body, body}, .springs = {spring}};
  range(rigid, OF(angle_per_step), "angle_per_step (rad) of RigidBodies", "above 0", {tiny, inf}, {0, -1});
  range(rigid, OF(spacings_per_step), "spacings_per_step (-) of RigidBodies", "above 0", {tiny, inf}, {0, -1});
  range(rigid, OF(contact.restitution), "restitution (-) of RigidContact", "0 to 1", {1}, {2});
  range(rigid, OF(bodies[1].properties.mass), "mass of a rigid body (kg)", "above 0", {tiny, huge}, {0, -1, inf});
  range(rigid, OF(bodies[0].properties.inertia(0, 0)), "inertia of a rigid body (kg m^2)", "above 0", {tiny, huge},
        {0, -1, inf});
  range(rigid, OF(bodies[0].velocity[1]), "velocity of a rigid body (m/s)", "finite", {-huge, 0}, {inf});
  range(rigid, OF(bodies[0].angular_velocity[0]), "angular velocity of a rigid body (rad/s)", "finite", {-huge}, {inf});
  range(rigid, OF(springs[0].stiffness), "stiffness (N/m) of Spring", "0 or more", {0, huge}, {-1, inf});
  range(rigid, OF(springs[0].damping), "damping (N s/m) of Spring", "0 or more", {0, huge}, {-1, inf});
  range(rigid, OF(springs[0].torsion), "torsion (N m/rad) of Spring", "0 or more", {0, huge}, {-1, inf});
  range(rigid, OF(springs[0].torsion_damping), "torsion_damping (N m s/rad) of Spring", "0 or more", {0, huge},
        {-1, inf});
  range(rigid, OF(springs[0].body), "body of a Spring", "the number of a rigid body, from 0", {0}, {-1, 2});
  range(rigid, OF(springs[0].point[0]), "a point of a Spring (m)", "finite", {-1}, {inf});
  for (int const number : {-1, 0, 2}) {
    auto changed = rigid;
    changed.springs[0].other = number;
    CHECK_THROWS_WITH(changed.check(), ContainsSubstring("other of a Spring must be the number of another rigid body"));
  }
  auto changed = rigid;
  changed.springs[0].length = -1;
  CHECK_THROWS_WITH(changed.check(), ContainsSubstring("length (m) of a Spring must be 0 or more, not -1"));
  changed = rigid;
  changed.bodies[1].properties.mass = -2;
  CHECK_THROWS_WITH(changed.check(), "scree: mass of a rigid body (kg) must be above 0, not -2 (rigid body 1)");
  changed = rigid;
  changed.bodies[0].given_velocity[0] = inf;
  CHECK_THROWS_WITH(changed.check(), ContainsSubstring("given velocity of a rigid body (m/s) must be finite"));
  changed = rigid;
  changed.bodies[0].given_turning[0] = nan;
  CHECK_THROWS_WITH(changed.check(),
                    ContainsSubstring("given angular velocity of a rigid body (rad/s) must be finite"));
}

}  // namespace scree::test::rigid_tests
