// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/start_in_space.hpp>
#include <scree/fields/particles.hpp>
#include <scree/granular/granular.hpp>
#include <scree/setup/hexagonal.hpp>
#include <scree/setup/rings.hpp>

#include <support/formulations.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

// The checks of positions on an execution space against those on the host, which are written in another way: other
// cells, another order of the sums.
namespace scree::test::start_in_space_tests {
namespace {

using Catch::Matchers::ContainsSubstring;

/// Material and walls of one case.
struct Case {
  int dim;
  double spacing;
  PlacedParticles all = {};
  std::size_t owned = 0;
  std::vector<Period> periods = {};
  StartWords words = {};
};
template <int Dim>
Case case_of(Points<Dim> const& material, Points<Dim> const& wall, double spacing, double volume = 1,
             std::vector<Period> const& periods = {}) {
  Case made{.dim = Dim, .spacing = spacing, .owned = material.size(), .periods = periods};
  made.all.add(material, volume * std::pow(spacing, Dim));
  made.all.add(wall, std::pow(spacing, Dim));
  return made;
}
template <class Space>
detail::Spots<Space> spots_of(Case const& of) {
  std::vector<detail::Spot> values;
  for (std::size_t i = 0; i < of.all.places.size(); ++i) {
    auto const& x = of.all.places[i];
    values.push_back({{x[0], x[1], x[2]}, of.all.volumes[i]});
  }
  detail::Spots<Space> spots(Space(), int(values.size()));
  copy_into(spots.all, values);
  spots.owned = int(of.owned);
  return spots;
}
template <class Action>
std::string message_of(Action const& action) {
  try {
    action();
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}
/// The message of the host, or "": the same as that of the execution space.
template <class Space>
std::string complaint(Case const& of) {
  std::string said;
  auto words = of.words;
  words.warn = [&](std::string const& text) { said += text; };
  auto const all_of = [&](auto const& check) {
    said.clear();
    std::string const message = message_of(check);
    return said + message;
  };
  auto const host = all_of([&] { check_start(of.all, of.owned, of.spacing, of.dim, of.periods, words); });
  auto const spots = spots_of<Space>(of);
  detail::StartIn<Space> look(spots, of.spacing, of.dim, of.periods);
  CHECK(look.can_look());
  if (look.can_look()) CHECK(all_of([&] { look.check_start(words); }) == host);
  return host;
}
bool agree(double one, double other) { return std::abs(one - other) <= 1e-12; }
/// Compares the packing of all and of a part of the material.
template <class Space>
void compare_packing(Case const& of) {
  auto const spots = spots_of<Space>(of);
  std::vector<char> some(of.owned);
  for (std::size_t i = 0; i < some.size(); ++i) some[i] = i % 3 != 1;
  for (auto const& counted : {std::vector<char>(), some}) {
    detail::StartIn<Space> look(spots, of.spacing, of.dim, of.periods);
    REQUIRE(look.can_look());
    detail::ArrayIn<char, Space> marks;
    if (!counted.empty()) marks = {Space(), "marks", counted.size()}, copy_into(marks, counted);
    Packing const here = look.packing(marks);
    Packing const host = packing_of(of.all, of.owned, of.spacing, of.dim, of.periods, {}, counted);
    CAPTURE(of.owned, counted.size(), host.density, here.density, host.nearest, here.nearest);
    CHECK(here.particles == host.particles);
    CHECK(here.full == host.full);
    CHECK(agree(here.density, host.density));
    CHECK((agree(here.loose, host.loose) && agree(here.dense, host.dense)));
    CHECK(agree(here.by_number, host.by_number));
    CHECK(agree(here.nearest, host.nearest));
    CHECK(agree(here.volume, host.volume));
  }
}
template <int Dim>
Points<Dim> together(Points<Dim> a, Points<Dim> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
template <int Dim>
Points<Dim> moved(Points<Dim> points, Vec<Dim, double> const& by) {
  for (auto& x : points) x += by;
  return points;
}
template <int Dim>
Vec<Dim, double> along(int axis, double length) {
  Vec<Dim, double> result = Vec<Dim, double>::Zero();
  result[axis] = length;
  return result;
}
/// A bed in the middle of a box with walls, not in the order of its places in memory.
template <int Dim>
Bed<Dim> bed(double jittered = 0) {
  auto made = open_bed<Dim>(Vec<Dim, double>::Constant(1.2), 0.1);
  std::shuffle(made.material.begin(), made.material.end(), std::mt19937(3));
  jitter(made.material, 0.1 * jittered, 5);
  return made;
}
template <int Dim>
std::vector<Case> beds() {
  std::vector<Case> all;
  std::vector<Period> const one{{0, 0, 1.2}}, two{{0, 0, 1.2}, {1, 0, 1.2}};
  for (double const jittered : {0.0, 0.1, 0.3}) {
    auto const [material, wall] = bed<Dim>(jittered);
    for (double const volume : {1.0, 0.8})
      for (auto const& periods : {std::vector<Period>(), one, two})
        all.push_back(case_of<Dim>(material, {}, 0.1, volume, periods));
    all.push_back(case_of<Dim>(material, wall, 0.1));
    all.push_back(case_of<Dim>(moved<Dim>(material, Vec<Dim, double>::Constant(-1234.5)), {}, 0.1));
  }
  all.push_back(
      case_of<Dim>(fill_hexagonal(Box<Dim>{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(1)}, 0.1), {}, 0.1));
  all.push_back(case_of<Dim>({}, bed<Dim>().wall, 0.1));
  all.push_back(case_of<Dim>({}, {}, 0.1));
  all.push_back(case_of<Dim>(
      {Vec<Dim, double>::Constant(1), Vec<Dim, double>::Constant(1e300), Vec<Dim, double>::Constant(std::nan(""))}, {},
      0.1));
  return all;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("an execution space finds the packing that the host finds", "", Backends) {
  for (auto const& each : beds<2>()) compare_packing<TestType>(each);
  for (auto const& each : beds<3>()) compare_packing<TestType>(each);
  // Other spacings than that of the particles.
  auto wrong = case_of<3>(bed<3>(0.2).material, bed<3>().wall, 0.1);
  for (double const spacing : {0.05, 0.08, 0.13, 0.2}) wrong.spacing = spacing, compare_packing<TestType>(wrong);
}

TEMPLATE_LIST_TEST_CASE("what may start on the host may start on an execution space", "", Backends) {
  for (auto const& each : beds<2>()) CHECK(complaint<TestType>(each) == "");
  for (auto const& each : beds<3>()) CHECK(complaint<TestType>(each) == "");
}

namespace {

template <class Space, int Dim>
void check_faults() {
  INFO(Dim);
  auto const [material, wall] = bed<Dim>();
  auto const refused = [&](Points<Dim> const& some, Points<Dim> const& walls, char const* why, double spacing = 0.1,
                           std::vector<Period> const& periods = {}) {
    CHECK_THAT(complaint<Space>(case_of<Dim>(some, walls, spacing, 1, periods)), ContainsSubstring(why));
  };
  // Every particle twice, single ones in the material and in walls, some at random.
  refused(together<Dim>(material, material), wall, "is 0 m from particle");
  for (std::size_t const i : {0u, 77u, 143u}) {
    refused(together<Dim>(material, {material[i]}), wall, ("particle " + std::to_string(i) + " at (").c_str());
    refused(together<Dim>({material[i]}, material), wall, "particle 0 at (");
    refused(material, together<Dim>(wall, {material[i] + along<Dim>(1, 0.004)}), "of the wall: a tenth of the spacing");
  }
  std::mt19937 random(11);
  for (int attempt = 0; attempt < 20; ++attempt) {
    auto many = material;
    for (int k = 0; k < 1 + attempt; ++k)
      many[random() % many.size()] = many[random() % many.size()] + along<Dim>(0, 0.0001 * k);
    refused(many, attempt % 2 == 0 ? wall : Points<Dim>(), "m from particle");
    refused(many, {}, "m from particle", 0.1, {{0, 0, 1.2}, {1, 0, 1.2}});
  }
  // Particles near to others, a bed in its floor, the wrong spacing.
  refused(together<Dim>(material, moved<Dim>(material, Vec<Dim, double>::Constant(0.04))), {}, "times as dense");
  refused(moved<Dim>(material, along<Dim>(Dim - 1, -0.1)), wall, " of the wall");
  auto const between = moved<Dim>(material, along<Dim>(0, 0.05));
  refused(moved<Dim>(between, along<Dim>(Dim - 1, -0.35)), wall, "do bodies overlap");
  refused(material, wall, "times as dense", 0.2);
  refused(material, wall, "settings.spacing", Dim == 2 ? 0.12 : 0.11);
  refused(material, wall, "has no neighbour within 1.5 spacings", 0.05);
  for (double const spacing : {0.09, 0.105}) refused(material, wall, "settings.spacing", spacing);
  Points<Dim> sparse;
  for (auto const& x : wall)
    if ((x.array() / 0.2 - (x.array() / 0.2).floor() < 0.5).all()) sparse.push_back(x);
  REQUIRE(sparse.size() > 20);
  refused(material, sparse, "the particles of walls are too far apart");
  // The same under many walls of the right spacing, which are far away.
  auto far = sparse;
  for (int k = 0; k < 3; ++k) far = together<Dim>(far, moved<Dim>(wall, along<Dim>(0, 20 + 10 * k)));
  refused(material, far, "scree: warning: the particles of a wall are far apart");
  // Both ends of a period.
  refused(material, {}, "m from particle", 0.1, {{0, 0, 1.1}});
  refused(material, {}, "m from particle", 0.1, {{1, 0, 1.2}, {0, 0, 1.195 - 0.09}});
  // Volumes of the material and of walls.
  CHECK_THAT(complaint<Space>(case_of<Dim>(material, wall, 0.1, 0.5)), ContainsSubstring("volumes are too small"));
  auto thin = case_of<Dim>(material, wall, 0.1);
  for (std::size_t i = thin.owned; i < thin.all.volumes.size(); ++i) thin.all.volumes[i] *= 0.5;
  CHECK_THAT(complaint<Space>(thin), ContainsSubstring("the particles of walls fill 0.5"));
  thin.words.judges_packing = false;
  CHECK(complaint<Space>(thin) == "");
  // A layer of one row is judged by the distance of neighbours.
  Box<Dim> row{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(3)};
  row.high[Dim - 1] = 0.1;
  refused(fill_lattice(row, 0.1), {}, "the nearest neighbour of a particle is 1.25 times", 0.08);
  auto loose = case_of<Dim>(material, {}, 0.05);
  loose.words.may_be_sparse = true;
  CHECK(complaint<Space>(loose) == "");
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("an execution space refuses the starts that the host refuses, in the same words", "",
                        Backends) {
  check_faults<TestType, 2>();
  check_faults<TestType, 3>();
}

TEMPLATE_LIST_TEST_CASE("many particles in one place are left to the host, which refuses them at once", "", Backends) {
  auto const crowd = case_of<3>(Points<3>(200'000, Vec<3, double>(1, 2, 3)), {}, 0.1);
  auto const spots = spots_of<TestType>(crowd);
  CHECK_FALSE(detail::StartIn<TestType>(spots, 0.1, 3, {}).can_look());
  // As many as fit a bucket are compared.
  auto const few = case_of<3>(Points<3>(400, Vec<3, double>(1, 2, 3)), {}, 0.1);
  CHECK_THAT(complaint<TestType>(few), ContainsSubstring("particle 0 at (1, 2, 3) m is 0 m from particle 1:"));
}

TEMPLATE_LIST_TEST_CASE("a hash of cells puts few cells of a lattice into one bucket", "", Backends) {
  Points<2> const plane = fill_lattice(Box<2>{{-20, 3}, {20, 33}}, 0.1);
  Points<3> const space = fill_lattice(Box<3>{{-4, 1, 2}, {4, 6, 4}}, 0.1);
  CHECK(detail::StartIn<TestType>(spots_of<TestType>(case_of<2>(plane, {}, 0.1)), 0.1, 2, {}).can_look());
  CHECK(detail::StartIn<TestType>(spots_of<TestType>(case_of<3>(space, {}, 0.1)), 0.1, 3, {}).can_look());
}

namespace {

/// The state of a solver, and what the checks say of it where its particles are and on the host.
template <int Dim, class Real, class Space>
void check_system() {
  using namespace fields;
  using F = Formulated<Policy<Dim, Real, Space>, Granular<>>;
  using Checks = detail::PositionChecks<F>;
  auto const [material, wall] = bed<Dim>();
  Granular<> sand;
  sand.law.elastic = {1e6, 0.3, 1500};
  sand.law.grains = {1e-3};
  SolverSettings<F> settings{.spacing = 0.1, .physics = sand};
  system_of<F> system(Space(), 0.15, {});
  auto const place = [&](auto& body, Points<Dim> const& points) {
    body.resize(int(points.size()));
    body.from_host(position, cast<Real>(points));
    body.fill(volume, Real(std::pow(0.1, Dim)));
  };
  place(system.template body<Material>(), material);
  place(system.template body<Wall>(), wall);
  CHECK(message_of([&] { CHECK(Checks::start_in_space(system, settings)); }) == "");
  settings.physics.law.elastic.young = 1;
  CHECK_THAT(message_of([&] { Checks::start_in_space(system, settings); }), ContainsSubstring("would crush it"));

  std::vector<Vec<symmetric_size<3> - (Dim == 2 ? 2 : 0), Real>> sigma(material.size());
  for (std::size_t i = 0; i < sigma.size(); ++i) sigma[i].setConstant(Real(material[i][0] > 0.6 ? 1 : -1));
  system.template body<Material>().from_host(stress, sigma);
  Packing loaded;
  CHECK(detail::look_in_space<F>(system, settings, [&](auto& look) {
    loaded = look.packing(detail::which_are_loaded(system.template body<Material>()));
  }));
  CHECK(2 * loaded.particles == long(material.size()));
  CHECK(std::abs(loaded.density - 1) < 0.01);

  auto twice = material;
  twice[44] = twice[55];
  system.template body<Material>().from_host(position, cast<Real>(twice));
  CHECK_THAT(message_of([&] { Checks::start_in_space(system, settings); }),
             ContainsSubstring(" is 0 m from particle ") && ContainsSubstring("particle 44"));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the particles of a solver are checked where they are, in both precisions", "", Backends) {
  check_system<2, double, TestType>();
  check_system<3, float, TestType>();
}

}  // namespace scree::test::start_in_space_tests
