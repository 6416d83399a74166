// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/plates.hpp>
#include <scree/checks/thin_walls.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/shapes/primitives.hpp>

#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>
#include <tuple>
#include <vector>

namespace scree::test::thin_walls_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
using X = Vec<2, double>;

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

/// A body of particles of volume 1; all of them belong to plates if it carries OnPlate.
template <class... Others>
Particles<OnHost, Fields<Position, Volume, Others...>> body_of(std::vector<X> const& points) {
  Particles<OnHost, Fields<Position, Volume, Others...>> body(int(points.size()));
  body.from_host(Position{}, points);
  body.fill(Volume{}, 1);
  (body.fill(Others{}, 1), ...);
  return body;
}
std::string fault(std::vector<X> const& material, std::vector<X> const& wall, bool turns = false) {
  ParticlesAtWalls particles;
  particles.add_wall(WholeBody(body_of<OnPlate>(wall)), true, std::vector<char>(turns ? wall.size() : 0, 1));
  PlacedParticles sand;
  sand.add(WholeBody(body_of(material)));
  particles.put_material(sand);
  return fault_of_thin_walls(particles, 1, 2);
}
std::vector<X> lattice(double x0, double y0, double x1, double y1) {
  return fill_lattice(Box<2>{{x0, y0}, {x1, y1}}, 1);
}
void add(std::vector<X>& points, std::vector<X> const& others) {
  points.insert(points.end(), others.begin(), others.end());
}

}  // namespace

TEST_CASE("a thin plate of few particles is found among many wall particles, wherever its particles stand in order") {
  auto const floor = lattice(0, -6, 20'000, 0);
  REQUIRE(floor.size() == 120'000);
  auto const plate = lattice(10'000, 4, 10'001, 16);
  REQUIRE(plate.size() == 12);
  auto sand = lattice(9'980, 0, 10'000, 20);
  add(sand, lattice(10'001, 0, 10'020, 20));
  CHECK(fault(sand, floor) == "");
  for (std::size_t before = 0; before <= floor.size(); before += 3000) {
    INFO(before << " particles of the floor come first");
    std::vector<X> wall(floor.begin(), floor.begin() + long(before));
    add(wall, plate);
    wall.insert(wall.end(), floor.begin() + long(before), floor.end());
    CHECK_THAT(fault(sand, wall), ContainsSubstring("at its particle " + std::to_string(before)) &&
                                      ContainsSubstring("at (10000.5, ") &&
                                      ContainsSubstring("material acts on material through a plate of 1 spacings"));
  }
}

TEST_CASE("one row of wall under a few grains is found among many wall particles with two rows") {
  auto wall = lattice(0, -2, 40'000, 0);
  add(wall, lattice(50'000, -1, 50'008, 0));
  auto sand = lattice(0, 0, 40'000, 1);
  CHECK(fault(sand, wall) == "");
  add(sand, lattice(50'000, 0, 50'008, 4));
  CHECK_THAT(fault(sand, wall),
             ContainsSubstring("at its particle 8000") && ContainsSubstring("-0.5) m: it has one row"));
}

TEST_CASE("three wall particles with a fault are a thin wall, two may be grains that have sunk in") {
  auto const around = [](int rows) {
    auto sand = lattice(0, 0, 9, rows + 16);
    add(sand, lattice(10, 0, 19, rows + 16));
    return fault(sand, lattice(9, 8, 10, 8 + rows));
  };
  CHECK(around(2) == "");
  CHECK_THAT(around(3), ContainsSubstring("at its particle 0 at (9.5, 8.5) m: material acts on material"));
}

TEST_CASE("a plate of two spacings may start at rest, and one that turns needs three") {
  auto const beside = [](int thick, bool turns) {
    auto sand = lattice(0, 0, 9, 20);
    add(sand, lattice(9 + thick, 0, 18 + thick, 20));
    return fault(sand, lattice(9, 4, 9 + thick, 16), turns);
  };
  CHECK(beside(2, false) == "");
  CHECK_THAT(beside(2, true), ContainsSubstring("a plate of 2 spacings turns; it needs three") &&
                                  ContainsSubstring("through a plate of less than 1.75"));
  CHECK_THAT(beside(1, true), ContainsSubstring("through a plate of 1 spacings"));
  CHECK(beside(3, true) == "");
  CHECK(beside(3, false) == "");
}

namespace {

std::string fault_with(double support, std::vector<X> const& material, std::vector<X> const& wall, bool plate = false) {
  ParticlesAtWalls particles;
  particles.support = support;
  particles.add_wall(WholeBody(body_of(wall)), !plate);
  PlacedParticles sand;
  sand.add(WholeBody(body_of(material)));
  particles.put_material(sand);
  return fault_of_thin_walls(particles, 1, 2);
}
/// A basin with walls of some rows.
std::string basin(double support, int rows) {
  auto wall = lattice(-rows, -rows, 20 + rows, 0);
  add(wall, lattice(-rows, 0, 0, 20)), add(wall, lattice(20, 0, 20 + rows, 20));
  return fault_with(support, lattice(0, 0, 20, 12), wall);
}
/// Two beds with a divider between them.
std::string divided(double support, int thick, bool plate = false) {
  auto sand = lattice(0, 0, 15, 30);
  add(sand, lattice(15 + thick, 0, 30 + thick, 30));
  return fault_with(support, sand, lattice(15, 0, 15 + thick, 30), plate);
}

}  // namespace

TEST_CASE("walls need rows for the support of the kernel, which is wider with a larger smoothing length") {
  struct Needs {
    double support;
    int rows, between, plate;
  };
  for (auto const& [support, rows, between, plate] :
       {Needs{2.2, 2, 4, 2}, Needs{3, 2, 4, 2}, Needs{3.4, 2, 4, 2}, Needs{4, 3, 4, 3}, Needs{4.5, 3, 6, 3},
        Needs{5, 4, 6, 3}, Needs{6, 5, 8, 4}}) {
    INFO("support " << support);
    for (int thick = 1; thick < 10; ++thick) {
      INFO(thick << " rows");
      CHECK((basin(support, thick) == "") == (thick >= rows));
      CHECK((divided(support, thick) == "") == (thick >= between));
      CHECK((divided(support, thick, true) == "") == (thick >= plate));
    }
  }
  CHECK_THAT(basin(6, 3), ContainsSubstring("the support of the kernel is 6 spacings: the material in front sees") &&
                              ContainsSubstring("it needs 6 rows"));
  CHECK_THAT(basin(5, 1), ContainsSubstring("walls end 0 spacings behind it") && ContainsSubstring("it needs 5 rows"));
  CHECK_THAT(divided(6, 7), ContainsSubstring("make it 8 spacings thick, or 4 and a plate"));
  CHECK_THAT(divided(6, 3, true), ContainsSubstring("through a plate of 3 spacings; a plate needs 4"));
}

namespace {

/// Schemes of a user with passes and fields of their own: one says what it does, the other does not.
struct Silent {
  auto velocity_passes() const { return std::tuple(0); }
  template <class Rho>
  std::tuple<> stress_passes(Rho const&, Gravity const&) const {
    return {};
  }
  template <class Rho>
  int lens(Rho const&, Gravity const&) const {
    return 0;
  }
};
struct Outspoken : Silent {
  static constexpr bool shows_means = false;
};
struct OnlyLens : Silent {
  std::tuple<> velocity_passes() const { return {}; }
};
struct OnlyLensOfMeans : OnlyLens {
  static constexpr bool shows_means = true;
};
template <class Scheme>
std::string fault_of(int thick) {
  auto sand = lattice(0, 0, 9, 20);
  add(sand, lattice(9 + thick, 0, 18 + thick, 20));
  ParticlesAtWalls particles;
  particles.add_wall(WholeBody(body_of(lattice(9, 4, 9 + thick, 16))), shows_means<Scheme>);
  PlacedParticles material;
  material.add(WholeBody(body_of(sand)));
  particles.put_material(material);
  return fault_of_thin_walls(particles, 1, 2);
}

}  // namespace

TEST_CASE("a wall scheme says whether it shows means; without a word it does if it computes something for the wall") {
  STATIC_CHECK(shows_means<Silent>);
  STATIC_CHECK(!shows_means<Outspoken>);
  STATIC_CHECK(!shows_means<OnlyLens>);
  STATIC_CHECK(shows_means<OnlyLensOfMeans>);
  STATIC_CHECK(shows_means<AdamiWalls>);
  STATIC_CHECK(shows_means<PlateWalls>);
  STATIC_CHECK(!shows_means<MirrorWalls>);
  CHECK_THAT(fault_of<Silent>(2), ContainsSubstring("shows each the mean of both"));
  CHECK_THAT(fault_of<OnlyLensOfMeans>(3), ContainsSubstring("shows each the mean of both"));
  CHECK(fault_of<Silent>(4) == "");
  CHECK(fault_of<Outspoken>(2) == "");
  CHECK(fault_of<OnlyLens>(2) == "");
  CHECK_THAT(fault_of<Outspoken>(1), ContainsSubstring("through a plate of 1 spacings"));
}

}  // namespace scree::test::thin_walls_tests
