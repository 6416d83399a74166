// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Several bodies that evolve, each with a physics model of its own.
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/formulation/describe.hpp>
#include <scree/formulation/physics_of_bodies.hpp>
#include <scree/granular/granular.hpp>
#include <scree/granular/parts.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/io/point_data_of.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/setup/geostatic.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

namespace scree::test::two_bodies_tests {
using namespace fields;

struct Sand : MaterialBody {
  static constexpr std::string_view name = "sand";
};
struct Block : MaterialBody {
  static constexpr std::string_view name = "block";
};

/// A force against the velocity, rate (1/s) times it.
struct Damping {
  double rate = 0;
  using reads = Fields<Velocity>;
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    return vector(typename vector::Scalar(-rate) * i[velocity]);
  }
};

namespace {
using Catch::Matchers::ContainsSubstring;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

/// Without a filter, and with walls that store nothing.
template <class Law>
struct Plain : GranularModels {
  using law = Law;
  using filter = NoFilter;
  using walls = MirrorWalls;
};
template <class Law>
struct Turning : Plain<Law> {
  using strain = ObjectiveStrain;
};
template <class Law>
struct Damped : Plain<Law> {
  using forces = std::tuple<Damping>;
};
template <class Law>
using Model = Granular<Plain<Law>>;

template <class OfSand, class OfBlock = OfSand>
using Pair = PhysicsOfBodies<EvolvedBy<Sand, OfSand>, EvolvedBy<Block, OfBlock>>;

template <class Q, class Physics, class Integrator = Midpoint, class List = Bodies<Sand, Block, Wall>>
struct TwoBodies : Formulated<Q, Physics> {
  using bodies = List;
  using integrator = Integrator;
};
template <class Q, class Integrator, template <class> class Models>
struct TwoGroups : Formulated<Q, Granular<Models<ByGroup<MuOfI<>>>>> {
  using integrator = Integrator;
};

MuOfI<> sand_of(double density, double young, double mu_s) {
  return {.elastic = {young, 0.3, density}, .grains = {0.01}, .mu_s = mu_s};
}
template <int Dim>
using Vector = Vec<Dim, double>;

/// The largest difference of a field of two lists of particles, over the largest value.
template <class Values>
double difference(Values const& a, Values const& b) {
  double largest = 0, error = 0;
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, double(norm(a[k])));
    error = std::max(error, double(norm((a[k] - b[k]).eval())));
  }
  REQUIRE(largest > 0);
  return error / largest;
}
template <class S, class F>
auto of_both(S const& solver, F field) {
  auto all = solver.template body<Sand>().to_host(field);
  auto const others = solver.template body<Block>().to_host(field);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

template <int Dim, class Real, class Integrator>
struct Case {
  using basis = Policy<Dim, Real, Kokkos::DefaultHostExecutionSpace>;
  using integrator = Integrator;
};
using Cases = std::tuple<Case<2, double, Midpoint>, Case<3, double, SymplecticEuler>, Case<2, double, SymplecticEuler>,
                         Case<2, double, VelocityVerlet>, Case<3, float, Midpoint>>;
}  // namespace

namespace {
template <class TestType, template <class> class Models>
void check_bodies_and_groups() {
  using Q = typename TestType::basis;
  using Real = typename Q::real;
  constexpr int dim = Q::dim;
  double const dr = 0.1;
  auto const bed = open_bed<dim>(Vector<dim>::Constant(0.6), dr);
  auto points = bed.material;
  jitter(points, 0.1 * dr, 1);
  Points<dim> below, above;
  for (auto const& x : points) (x[dim - 1] < 0.3 ? below : above).push_back(x);
  Groups<dim> groups;
  groups.add("below", below).add("above", above);
  MuOfI<> const heavy = sand_of(2500, 2e5, 0.6), light = sand_of(1200, 1e5, 0.2);

  ByGroup<MuOfI<>> law(groups);
  law.set(0, heavy).set(1, light);
  using OneBody = TwoGroups<Q, typename TestType::integrator, Models>;
  Groups<dim> walls;
  walls.add("wall", bed.wall);
  Solver<OneBody> one({.spacing = dr, .physics = {.law = law}, .start_checks = false}, groups, walls);
  using F = TwoBodies<Q, Pair<Granular<Models<MuOfI<>>>>, typename TestType::integrator>;
  auto const sand = cast<Real>(below), block = cast<Real>(above), wall = cast<Real>(bed.wall);
  Solver<F> two({.spacing = dr, .physics = typename F::physics({.law = heavy}, {.law = light}), .start_checks = false},
                particles_of<Sand>(sand), particles_of<Block>(block), particles_of<Wall>(wall));
  for (int k = 0; k < 40; ++k) {
    double const dt = one.step(1), same = two.step(1);
    REQUIRE(std::abs(dt - same) <= ulps<Q>(10) * dt);
  }
  double const of_velocity = difference(one.material().to_host(velocity), of_both(two, velocity)),
               of_stress = difference(one.material().to_host(stress), of_both(two, stress));
  INFO("velocity " << of_velocity << ", stress " << of_stress << ", in units of rounding " << of_velocity / ulps<Q>(1));
  CHECK(of_velocity < ulps<Q>(50));  // 1e-14 in double
  CHECK(of_stress < ulps<Q>(50));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("two sands as bodies move as two groups of one body", "", Cases) {
  check_bodies_and_groups<TestType, Plain>();
}
TEMPLATE_TEST_CASE("with the objective strain two sands as bodies move as two groups, too", "",
                   (Case<2, double, Midpoint>), (Case<3, double, SymplecticEuler>)) {
  check_bodies_and_groups<TestType, Turning>();
}

TEST_CASE("a body of groups with densities of their own moves beside another body as one of one law") {
  double const dr = 0.1;
  auto const bed = open_bed<2>(Vector<2>::Constant(0.6), dr);
  auto points = bed.material;
  jitter(points, 0.1 * dr, 1);
  Points<2> below, above;
  for (auto const& x : points) (x[1] < 0.3 ? below : above).push_back(x);
  MuOfI<> const heavy = sand_of(2500, 2e5, 0.6), light = sand_of(1200, 1e5, 0.2);
  Groups<2> groups;
  groups.add("below", below);
  ByGroup<MuOfI<>> law(groups);
  law.set(0, heavy);
  using OfLaws = TwoBodies<OnHost, Pair<Model<MuOfI<>>>>;
  using OfGroups = TwoBodies<OnHost, Pair<Model<ByGroup<MuOfI<>>>, Model<MuOfI<>>>>;
  Solver<OfLaws> one({.spacing = dr, .physics = OfLaws::physics({.law = heavy}, {.law = light}), .start_checks = false},
                     particles_of<Sand>(below), particles_of<Block>(above), particles_of<Wall>(bed.wall));
  Solver<OfGroups> two(
      {.spacing = dr, .physics = OfGroups::physics({.law = law}, {.law = light}), .start_checks = false},
      particles_of<Sand>(groups), particles_of<Block>(above), particles_of<Wall>(bed.wall));
  for (int k = 0; k < 40; ++k) {
    double const dt = one.step(1);
    REQUIRE(std::abs(dt - two.step(1)) <= 1e-14 * dt);
  }
  CHECK(difference(of_both(one, velocity), of_both(two, velocity)) < 1e-13);
  CHECK(difference(of_both(one, stress), of_both(two, stress)) < 1e-13);
}

namespace {
double mass_of(Elastic const& law, double volume) { return law.rest_density * volume; }
double mass_of(MuOfI<> const& law, double volume) { return mass_of(law.elastic, volume); }
/// The momentum of both bodies, and the sum of the magnitudes of those of all particles.
template <class S>
std::pair<Vector<S::policy::dim>, double> momentum_of(S const& solver) {
  std::pair<Vector<S::policy::dim>, double> sum{Vector<S::policy::dim>::Zero(), 0};
  auto const add = [&]<class Body>(Bodies<Body>) {
    auto const& law = solver.settings().physics.template of_body<Body>().law;
    auto const u = solver.template body<Body>().to_host(velocity);
    auto const V = solver.template body<Body>().to_host(volume);
    for (std::size_t k = 0; k < u.size(); ++k) {
      Vector<S::policy::dim> const of_particle = mass_of(law, V[k]) * u[k].template cast<double>();
      sum.first += of_particle, sum.second += of_particle.norm();
    }
  };
  add(Bodies<Sand>{}), add(Bodies<Block>{});
  return sum;
}
/// s:s/(4 G) + p^2/(2 K), J/m^3.
double stored(Elastic const& law, StressTensor<double> const& sigma) {
  double const p = sigma.trace() / 3;
  return deviator_of(sigma).squaredNorm() / (4 * law.shear_modulus()) + p * p / (2 * law.bulk_modulus());
}
/// The kinetic and elastic energy of two elastic bodies.
template <class S>
double energy_of(S const& solver) {
  double sum = 0;
  auto const add = [&]<class Body>(Bodies<Body>) {
    Elastic const& law = solver.settings().physics.template of_body<Body>().law;
    auto const u = solver.template body<Body>().to_host(velocity);
    auto const sigma = solver.template body<Body>().to_host(stress);
    auto const V = solver.template body<Body>().to_host(volume);
    for (std::size_t k = 0; k < u.size(); ++k)
      sum += V[k] * (law.rest_density * u[k].squaredNorm() / 2 + stored(law, unpacked(sigma[k])));
  };
  add(Bodies<Sand>{}), add(Bodies<Block>{});
  return sum;
}

/// Two boxes, one above the other, of displaced particles.
template <int Dim>
struct TwoBoxes {
  Points<Dim> below, above;
};
template <int Dim>
TwoBoxes<Dim> two_boxes(double edge, double gap, double spacing) {
  Box<Dim> low{Vector<Dim>::Zero(), Vector<Dim>::Constant(edge)}, high = low;
  high.low[Dim - 1] += edge + gap, high.high[Dim - 1] += edge + gap;
  TwoBoxes<Dim> boxes{fill_lattice(low, spacing), fill_lattice(high, spacing)};
  jitter(boxes.below, 0.1 * spacing, 1), jitter(boxes.above, 0.1 * spacing, 2);
  return boxes;
}
template <class F>
Solver<F> thrown(typename F::physics const& physics, TwoBoxes<F::dim> const& boxes, double spacing, double speed) {
  using Real = typename F::real;
  auto const sand = cast<Real>(boxes.above), block = cast<Real>(boxes.below);
  Solver<F> solver({.spacing = spacing, .physics = physics, .start_checks = false}, particles_of<Sand>(sand),
                   particles_of<Block>(block));
  using vector = Vec<F::dim, Real>;
  solver.template set<Sand>(velocity, [&](vector const&) { return vector(Real(-speed) * vector::Unit(F::dim - 1)); });
  solver.template set<Block>(velocity, [&](vector const&) { return vector(Real(speed) * vector::Unit(F::dim - 1)); });
  return solver;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("sand that meets a falling elastic block exchanges momentum with it to rounding", "", Cases) {
  using Q = typename TestType::basis;
  using F = TwoBodies<Q, Pair<Model<MuOfI<>>, Model<Elastic>>, typename TestType::integrator, Bodies<Sand, Block>>;
  constexpr int dim = Q::dim;
  double const dr = 0.1, g = 9.81;
  typename F::physics const physics({.law = sand_of(1500, 1e5, 0.4), .viscosity_speed = 0.2},
                                    {.law = {3e5, 0.2, 4000}, .viscosity_speed = 1.5});
  auto solver = thrown<F>(physics, two_boxes<dim>(0.5, 1.5 * dr, dr), dr, 0.5);
  auto const before = momentum_of(solver).first;
  auto const block_before = solver.template body<Block>().to_host(velocity);
  double mass = 0;
  for (auto const& V : solver.template body<Sand>().to_host(volume)) mass += 1500 * V;
  for (auto const& V : solver.template body<Block>().to_host(volume)) mass += 4000 * V;
  double largest = 0;
  for (int k = 0; k < 200; ++k) {
    solver.step(1);
    auto const [momentum, magnitude] = momentum_of(solver);
    Vector<dim> const expected = before - mass * g * solver.time() * Vector<dim>::Unit(dim - 1);
    largest = std::max(largest, (momentum - expected).norm() / magnitude);
  }
  auto const u = solver.template body<Block>().to_host(velocity);
  Vector<dim> const pushed = u[0].template cast<double>() - block_before[0].template cast<double>() +
                             g * solver.time() * Vector<dim>::Unit(dim - 1);
  INFO("momentum " << largest / ulps<Q>(1) << " units of rounding, of the block " << pushed.norm());
  CHECK(difference(u, block_before) > 0.1);
  CHECK(largest < ulps<Q>(60));
}

TEMPLATE_LIST_TEST_CASE("two elastic blocks that are welded keep their energy", "", DoublePolicies) {
  using Q = TestType;
  using F = TwoBodies<Q, Pair<Model<Elastic>>, Midpoint, Bodies<Sand, Block>>;
  constexpr int dim = Q::dim;
  double const dr = 0.1;
  auto const change = [&](double cfl) {
    Model<Elastic> light{.law = {1e5, 0.3, 1000}}, heavy{.law = {4e5, 0.2, 3000}};
    light.gravity.magnitude = heavy.gravity.magnitude = 0;
    light.viscosity_speed = heavy.viscosity_speed = 0;
    light.cfl = heavy.cfl = cfl;
    auto solver = thrown<F>(typename F::physics(light, heavy), two_boxes<dim>(0.5, 0, dr), dr, 0.1);
    double const before = energy_of(solver);
    double largest = 0;
    while (solver.time() < 0.1) {
      solver.step(1);
      largest = std::max(largest, std::abs(energy_of(solver) / before - 1));
    }
    return largest;
  };
  double const coarse = change(0.1), fine = change(0.05);
  INFO("change of the energy " << coarse << ", with half the step " << fine);
  CHECK(coarse < 1e-3);
  CHECK(fine < coarse / 4);
}

TEST_CASE("the order of bodies changes no bit") {
  using Models = Pair<Model<MuOfI<>>, Model<Elastic>>;
  using Swapped = PhysicsOfBodies<EvolvedBy<Block, Model<Elastic>>, EvolvedBy<Sand, Model<MuOfI<>>>>;
  using F = TwoBodies<OnHost, Models, SymplecticEuler, Bodies<Sand, Block>>;
  using G = TwoBodies<OnHost, Swapped, SymplecticEuler, Bodies<Block, Sand>>;
  Model<MuOfI<>> const sand{.law = sand_of(1500, 1e5, 0.4)};
  Model<Elastic> const block{.law = {3e5, 0.2, 4000}};
  auto const boxes = two_boxes<2>(0.5, 0.1, 0.1);
  auto one = thrown<F>(Models(sand, block), boxes, 0.1, 0.5);
  auto other = thrown<G>(Swapped(block, sand), boxes, 0.1, 0.5);
  for (int k = 0; k < 100; ++k) REQUIRE(one.step(1) == other.step(1));
  CHECK(of_both(one, velocity) == of_both(other, velocity));
  CHECK(of_both(one, stress) == of_both(other, stress));
}

namespace {
struct Settlement {
  double block, sand;  // of the uppermost rows, over the exact ones
};
/// Sand on an elastic block on a floor, periodic to the sides, at rest under its own weight. Both are 0.2 m high. The
/// sand begins without stress, or with that of its weight, so that it does not settle itself.
template <class Q>
Settlement settlement(int rows, bool stressed) {
  using Real = typename Q::real;
  using F = TwoBodies<Q, Pair<Granular<Damped<MuOfI<>>>, Granular<Damped<Elastic>>>, SymplecticEuler>;
  constexpr int dim = Q::dim, up = dim - 1;
  double const H = 0.2, dr = H / rows, L = 7 * dr, g = 9.81;
  Elastic const rubber{2e6, 0.3, 2000}, of_sand{1e6, 0.4, 1600};
  Box<dim> below{Vector<dim>::Zero(), Vector<dim>::Constant(L)}, above = below, floor = below;
  below.high[up] = H, above.low[up] = H, above.high[up] = 2 * H, floor.low[up] = -4 * dr, floor.high[up] = 0;
  auto const block = fill_lattice(below, dr), sand = fill_lattice(above, dr), wall = fill_lattice(floor, dr);
  Damping const critical{.rate = std::numbers::pi / (2 * H) * of_sand.sound_speed()};
  SolverSettings<F> settings{.spacing = dr};
  settings.physics =
      typename F::physics({.law = {.elastic = of_sand, .grains = {1e-3}}, .cfl = 0.8, .forces = {critical}},
                          {.law = rubber, .cfl = 0.8, .forces = {critical}});
  for (int axis = 0; axis < up; ++axis) settings.periods.push_back({axis, 0, L});
  auto const sand_here = cast<Real>(sand), block_here = cast<Real>(block), wall_here = cast<Real>(wall);
  Solver<F> solver(settings, particles_of<Sand>(sand_here), particles_of<Block>(block_here),
                   particles_of<Wall>(wall_here));
  Geostatic const at_rest{2 * H, of_sand.rest_density, g, of_sand.poisson / (1 - of_sand.poisson)};
  if (stressed)
    solver.template set<Sand>(stress, [&](auto const& x) { return packed<dim>(StressTensor<double>(at_rest(x))); });
  solver.run(0.1);

  // Between two depths under a load a layer is shortened by the integral of 1 - exp(-p/M), p the weight above.
  auto const shortened = [&](Elastic const& law, double load, double from, double to) {
    double const M = law.bulk_modulus() + 4 * law.shear_modulus() / 3, a = M / (law.rest_density * g);
    auto const primitive = [&](double depth) { return depth + a * std::exp(-load / M - depth / a); };
    return primitive(to) - primitive(from);
  };
  double const load = of_sand.rest_density * g * H, whole = shortened(rubber, load, 0, H);
  auto const mean_of_top = [&](auto const& start, auto const& x, double height) {
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < start.size(); ++k)
      if (start[k][up] > height - 0.75 * dr) sum += start[k][up] - double(x[k][up]), ++count;
    return sum / count;
  };
  return {mean_of_top(block, solver.template body<Block>().to_host(position), H) / shortened(rubber, load, dr / 2, H),
          mean_of_top(sand, solver.template body<Sand>().to_host(position), 2 * H) /
              (whole + (stressed ? 0 : shortened(of_sand, 0, dr / 2, H)))};
}
}  // namespace

// Where the strain jumps, the kernel averages it over both bodies: the settlement of the interface has an error of
// about a spacing times the jump. Without stress at the start both bodies are strained nearly alike; under sand that is
// stressed before, the jump is the whole strain of the block.
TEMPLATE_LIST_TEST_CASE("sand shortens an elastic block by what the oedometric modulus says", "", DoublePolicies) {
  auto const check = [](int rows, bool stressed, double bar) {
    auto const [block, sand] = settlement<TestType>(rows, stressed);
    INFO(rows << " rows, " << (stressed ? "stressed" : "unstressed") << ": block " << block << ", sand " << sand
              << " of the exact settlement");
    CHECK(std::abs(block - 1) < bar);
    CHECK(std::abs(sand - 1) < bar);
  };
  check(10, false, 0.02);
  if constexpr (TestType::dim == 2) {
    check(20, false, 0.005);
    check(10, true, 0.07);
    check(20, true, 0.02);
  }
}

namespace {
/// With the lists and the filter of most cases.
struct Usual : Formulation<2> {
  struct Models : GranularModels {
    using walls = MirrorWalls;
  };
  using space = Kokkos::DefaultHostExecutionSpace;
  using bodies = Bodies<Sand, Block, Wall>;
  using physics = Pair<Granular<Models>, Model<Elastic>>;
};
Solver<Usual> usual() {
  double const dr = 0.1;
  auto const bed = open_bed<2>({0.6, 0.6}, dr);
  Points<2> block, sand;
  for (auto const& x : bed.material) (x[1] < 0.3 ? block : sand).push_back(x);
  Granular<Usual::Models> of_sand{.law = sand_of(1500, 1e5, 0.2)};
  of_sand.filter.period = 7;
  return Solver<Usual>({.spacing = dr, .physics = Usual::physics(of_sand, {.law = {3e5, 0.2, 4000}})},
                       particles_of<Sand>(sand), particles_of<Block>(block), particles_of<Wall>(bed.wall));
}
}  // namespace

TEST_CASE("two bodies that evolve go on from a snapshot bit for bit") {
  auto before = usual(), after = usual();
  for (int k = 0; k < 150; ++k) before.step(1);
  after.restore(before.snapshot());
  for (int k = 0; k < 150; ++k) REQUIRE(before.step(1) == after.step(1));
  CHECK(of_both(before, position) == of_both(after, position));
  CHECK(of_both(before, stress) == of_both(after, stress));
}

TEST_CASE("the filter acts on the body whose model has it, in its own period") {
  auto solver = usual();
  auto const smoothed = [&] { return solver.body<Sand>().to_host(Smoothed<Stress>{}); };
  while (solver.steps() < 6) solver.step(1);
  auto const before = smoothed();
  REQUIRE(!before.empty());
  CHECK(std::all_of(before.begin(), before.end(), [](auto const& sigma) { return norm(sigma) == 0; }));
  solver.step(1);
  CHECK(difference(smoothed(), solver.body<Sand>().to_host(stress)) == 0);
  static_assert(!OneOf<Smoothed<Stress>, carried_fields<Usual, Block>>);
}

TEST_CASE("outputs and the description of a step name the bodies that evolve") {
  auto solver = usual();
  solver.step(1);
  auto const written = point_data_of(solver, Fields<Stress>{}, Bodies<Sand, Block>{});
  auto const& number = std::get<std::vector<std::int32_t>>(written.arrays[1].values);
  CHECK(number.size() == std::size_t(solver.body<Sand>().size() + solver.body<Block>().size()));
  CHECK(number.front() == 0);
  CHECK(number.back() == 1);
  CHECK_THAT(describe(solver), ContainsSubstring("sand over sand and wall and block") &&
                                   ContainsSubstring("block over block and wall and sand"));
  CHECK_THAT(parts_of(solver), ContainsSubstring("physics of sand: scree::Granular") &&
                                   ContainsSubstring("physics of block: scree::Granular") &&
                                   ContainsSubstring("law: scree::Elastic"));
  CHECK(solver.particles_at_start() == 36);
  CHECK(solver.lost() == 0);
}

TEST_CASE("faults of each body are found") {
  SECTION("a setting") {
    auto physics = usual().settings().physics;
    physics.of_body<Block>().law.young = -1;
    CHECK_THROWS_WITH(physics.check(), ContainsSubstring("young"));
  }
  SECTION("a value that is not finite, in the block") {
    auto solver = usual();
    solver.step(1);
    solver.set<Block>(velocity, [](auto const& x) { return Vec<2, double>(x[0] < 0.1 ? NAN : 0.0, 0); });
    CHECK_THROWS_WITH(solver.run(1), ContainsSubstring(" of the block is not finite"));
  }
  SECTION("a value that is not finite, in the sand") {
    auto solver = usual();
    solver.step(1);
    solver.set<Sand>(velocity, [](auto const& x) { return Vec<2, double>(x[0] < 0.1 ? NAN : 0.0, 0); });
    CHECK_THROWS_WITH(solver.run(1), ContainsSubstring(" of the sand is not finite"));
  }
  SECTION("the step is that of the stiffer one, whichever it is") {
    double const h = 0.15, of_sand = 0.2 * h / sand_of(1500, 1e5, 0.2).elastic.sound_speed();
    for (double const young : {1e5, 1e7}) {
      auto const former = usual();
      auto settings = former.settings();
      settings.physics.of_body<Block>().law.young = young;
      auto const bed = open_bed<2>({0.6, 0.6}, 0.1);
      Solver<Usual> solver(settings, particles_of<Sand>(former.body<Sand>().to_host(position)),
                           particles_of<Block>(former.body<Block>().to_host(position)), particles_of<Wall>(bed.wall));
      double const expected = std::min(of_sand, 0.2 * h / Elastic{young, 0.2, 4000}.sound_speed());
      double const dt = solver.step(1);
      CAPTURE(young, expected, dt);
      CHECK(dt <= expected * (1 + 1e-9));
      CHECK(dt > 0.9 * expected);
    }
  }
  SECTION("gravities that differ") {
    auto physics = usual().settings().physics;
    physics.of_body<Block>().gravity.magnitude = 1;
    CHECK_THROWS_WITH(physics.check(), ContainsSubstring("gravities that differ"));
  }
  SECTION("points that no body is named for") {
    auto const bed = open_bed<2>({0.6, 0.6}, 0.1);
    CHECK_THROWS_WITH(Solver<Usual>({.spacing = 0.1}, bed.material, bed.wall),
                      ContainsSubstring("2 bodies that are a material: name each"));
  }
}

TEST_CASE("a diameter of grains in mm is warned about in each of several bodies") {
  double const dr = 0.02;
  auto const boxes = two_boxes<2>(0.2, 0.1, dr);
  using F = TwoBodies<OnHost, Pair<Model<MuOfI<>>>>;
  auto const said = [&](double of_sand, double of_block) {
    MuOfI<> sand = sand_of(1500, 2e6, 0.3), block = sand;
    sand.grains.diameter = of_sand, block.grains.diameter = of_block;
    std::string all;
    Solver<F> solver({.spacing = dr,
                      .physics = F::physics({.law = sand}, {.law = block}),
                      .start_checks = true,
                      .warn = [&](std::string const& text) { all += text; }},
                     particles_of<Sand>(boxes.above), particles_of<Block>(boxes.below));
    solver.check_start();
    return all;
  };
  using Catch::Matchers::ContainsSubstring;
  CHECK(said(0.001, 0.002) == "");
  CHECK_THAT(said(1, 0.002), ContainsSubstring("the diameter of the grains, 1 m"));
  CHECK_THAT(said(0.001, 2), ContainsSubstring("the diameter of the grains, 2 m"));
}

}  // namespace scree::test::two_bodies_tests
