// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/thin_walls.hpp>
#include <scree/checks/thin_walls_in_space.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/shapes/primitives.hpp>

#include <support/backends.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>
#include <vector>

// The look for thin walls on an execution space counts the particles that the host finds.
namespace scree::test::thin_walls_in_space_tests {
namespace {

/// Material and walls of one case; the walls may be plates and turn.
template <int Dim>
struct Case {
  double spacing;
  std::vector<Vec<Dim, double>> material, wall;
  std::vector<char> is_plate, turns;

  long on_host() const {
    ParticlesAtWalls particles;
    particles.all.add(wall, 1.0);
    particles.is_plate = is_plate, particles.turns = turns;
    PlacedParticles sand;
    sand.add(material, 1.0);
    particles.put_material(sand);
    return long(ThinWalls(particles, spacing, Dim).faults());
  }
  template <class Space>
  long in_space() const {
    std::vector<detail::Spot> values;
    for (auto const* points : {&material, &wall})
      for (auto const& x : *points) values.push_back({{x[0], x[1], Dim == 3 ? x[Dim - 1] : 0}, 1});
    detail::Spots<Space> spots(Space(), int(values.size()));
    copy_into(spots.all, values);
    spots.owned = int(material.size());
    return detail::faults_of_thin_walls(spots, spacing, Dim, marks<Space>(is_plate), marks<Space>(turns));
  }

 private:
  template <class Space>
  static detail::ArrayIn<char, Space> marks(std::vector<char> const& values) {
    detail::ArrayIn<char, Space> copy(Space(), "marks", values.size());
    copy_into(copy, values);
    return copy;
  }
};

/// A box of sand with walls of 1 to 4 rows around it and one of 1 to 5 across, all displaced by up to `jitter`.
template <int Dim>
Case<Dim> divided_box(std::mt19937& random, double jitter, bool plates) {
  auto const whole = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
  double const dr = 0.5;
  int const length = Dim == 3 ? 11 : 25, rows = whole(1, 4), across = whole(1, 5), from = whole(5, length - 9);
  Case<Dim> made{.spacing = dr};
  Box<Dim> box{Vec<Dim, double>::Constant(-rows * dr), Vec<Dim, double>::Constant((length + rows) * dr)};
  for (auto x : fill_lattice(box, dr)) {
    bool const is_outside = (x.array() < 0).any() || (x.array() > length * dr).any();
    bool const is_divider = x[0] > from * dr && x[0] < (from + across) * dr;
    for (int axis = 0; axis < Dim; ++axis) x[axis] += jitter * dr * (double(random()) / 4294967296.0 - 0.5);
    (is_outside || is_divider ? made.wall : made.material).push_back(x);
    if (is_outside || is_divider) made.is_plate.push_back(plates && is_divider && !is_outside);
  }
  made.turns.assign(made.wall.size(), char(whole(0, 1)));
  return made;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("thin walls are found on the execution space where they are found on the host", "", Backends) {
  using Space = TestType;
  std::mt19937 random(11);
  int found = 0, none = 0;
  auto const compare = [&](auto const& of) {
    long const host = of.on_host();
    CHECK(of.template in_space<Space>() == host);
    ++(host > 0 ? found : none);
  };
  for (int k = 0; k < 60; ++k)
    for (double const jitter : {0.0, 0.3}) {
      INFO("case " << k << ", displaced by " << jitter);
      compare(divided_box<2>(random, jitter, k % 2 == 1));
      if (k < 16) compare(divided_box<3>(random, jitter, k % 2 == 1));
    }
  CHECK(found > 40);
  CHECK(none > 20);
}

TEMPLATE_LIST_TEST_CASE("walls without material, and material in one place, are left to the host or have no fault", "",
                        Backends) {
  using Space = TestType;
  Case<2> const empty{.spacing = 1, .wall = {{0, 0}, {1, 0}, {2, 0}}, .is_plate = {0, 0, 0}};
  CHECK(empty.template in_space<Space>() == 0);
  Case<2> crowded = empty;
  crowded.material.assign(5000, {1, 1});
  CHECK(crowded.template in_space<Space>() == -1);
}

}  // namespace scree::test::thin_walls_in_space_tests
