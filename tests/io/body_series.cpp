// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hdf5_file.hpp"
#include "series_step.hpp"

#include <scree/io/body_series.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numeric>

// Whole files, read back with HDF5. The order of components: in_space.cpp.
namespace scree::test::body_series_tests {
using namespace fields;
namespace {

struct Distortion : Tensor<"distortion", "1"> {};
struct CellNumber : Integer<"cell number", "1"> {};

struct NumberCells {
  using reads = Fields<Position, Concentration>;
  using writes = Fields<Distortion, CellNumber>;
  template <class I, class Out>
  SCREE_FN void operator()(I const& i, Out& out) const {
    out[Distortion{}] = outer(i[position], i[position]);
    out[CellNumber{}] = static_cast<int>(10 * i[concentration]);
  }
};
struct Cells {
  auto passes(Resolution const&) const { return std::tuple(point_pass<Material>("cells", NumberCells{})); }
};

struct NothingHappens {
  using evolves = Fields<Velocity, Stress, Concentration>;
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};

template <int Dim, class Real>
struct Case : Formulation<Dim, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = NothingHappens;
  using diagnostics = Cells;
};

struct Speed : Scalar<"speed", "m/s"> {
  using reads = Fields<Velocity, Concentration>;
  template <class I>
  static double of(I const& i, Resolution const& resolution) {
    return double(norm(i[velocity])) + double(i[concentration]) + resolution.spacing;
  }
};

struct OtherSpeed : Scalar<"speed", "m/s"> {
  using reads = Fields<Velocity>;
  template <class I>
  static double of(I const&, Resolution const&) {
    return 0;
  }
};

template <int Dim, class Real>
auto points(int number, Real shift = 0) {
  std::vector<Vec<Dim, Real>> points;
  for (int k = 0; k < number; ++k) {
    points.emplace_back(Vec<Dim, Real>::Constant(shift));
    points.back()[0] += Real(k), points.back()[Dim - 1] += Real(0.5) * Real(k);
  }
  return points;
}

/// Particle k is at (k, 0.5 k), or (k, 0, 0.5 k), of the wall one down and one to the left; its speed is (1, k)...
template <int Dim, class Real>
auto solver_of_three(int wall = 0, int material = 3) {
  Solver<Case<Dim, Real>> solver({.spacing = 0.5, .physics = {}, .start_checks = false}, points<Dim, Real>(material),
                                 points<Dim, Real>(wall, -1));
  auto number_of = [](auto const& x) { return x[0]; };
  solver.set(velocity, [&](auto const& x) {
    Vec<Dim, Real> v = Vec<Dim, Real>::Zero();
    v[0] = 1, v[Dim - 1] = number_of(x);
    return v;
  });
  solver.set(concentration, [&](auto const& x) { return Real(0.25) * number_of(x); });
  solver.set(stress, [&](auto const& x) {
    auto s = zero<Vec<symmetric3_size<Dim>, Real>>();
    for (int k = 0; k < symmetric3_size<Dim>; ++k) s[k] = Real(k + 1) + Real(10) * number_of(x);
    return s;
  });
  return solver;
}

using All = Fields<Velocity, Stress, Concentration, Volume, Distortion, CellNumber, Identity, Pressure, Speed>;
using Shape = std::vector<hsize_t>;

template <class T>
std::vector<T> numbers_in(File const& file, std::string const& name) {
  return file.read<T>("VTKHDF/PointData/" + name);
}

/// The types that belong to a precision.
template <class Real>
hid_t stored() {
  return std::is_same_v<Real, double> ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
}

template <int Dim_, class Real_>
struct In {
  static constexpr int Dim = Dim_;
  using Real = Real_;
};

}  // namespace

TEMPLATE_TEST_CASE("a body series has the names, components, units and numbers of its fields", "", (In<2, double>),
                   (In<2, float>), (In<3, double>), (In<3, float>)) {
  using Real = typename TestType::Real;
  constexpr int Dim = TestType::Dim;
  Folder const folder;
  auto solver = solver_of_three<Dim, Real>();
  BodySeries output(folder / "a.vtkhdf", All{});
  output.append(solver);
  CHECK(output.steps() == 1);
  File const file(output.path());
  auto const check = [&](std::string const& name, Shape const& shape, char const* unit, std::vector<Real> const& wanted,
                         hid_t type = stored<Real>()) {
    INFO(name);
    auto const path = "VTKHDF/PointData/" + name;
    CHECK(file.shape(path) == shape);
    CHECK(file.text(path.c_str(), "units") == unit);
    CHECK(file.stored_as(path, type));
    CHECK(numbers_in<Real>(file, name) == wanted);
  };
  CHECK(file.stored_as("VTKHDF/Points", stored<Real>()));
  CHECK(file.read<Real>("VTKHDF/Points") == std::vector<Real>{0, 0, 0, 1, 0, 0.5, 2, 0, 1});
  check("velocity", {3, 3}, "m/s", {1, 0, 0, 1, 0, 1, 1, 0, 2});
  check("concentration", {3}, "1", {0, 0.25, 0.5});
  check("volume", {3}, Dim == 2 ? "m^2" : "m^3", std::vector<Real>(3, Real(std::pow(0.5, Dim))));
  check("distortion", {3, 9}, "1",
        {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0, 0.5, 0, 0.25, 4, 0, 2, 0, 0, 0, 2, 0, 1});
  check("cell_number", {3}, "1", {0, 2, 5}, H5T_STD_I32LE);
  check("identity", {3}, "1", {0, 1, 2}, H5T_STD_I32LE);
  check("pressure", {3}, "Pa", {-2, -12, -22});
  if (Dim == 2)  // 1, 2, 3 out of the plane, 4 in it
    check("stress", {3, 6}, "Pa", {1, 3, 2, 0, 0, 4, 11, 13, 12, 0, 0, 14, 21, 23, 22, 0, 0, 24});
  else
    check("stress", {3, 6}, "Pa", {1, 2, 3, 4, 6, 5, 11, 12, 13, 14, 16, 15, 21, 22, 23, 24, 26, 25});
  CHECK(file.stored_as("VTKHDF/PointData/speed", H5T_IEEE_F64LE));  // as computed
  CHECK(std::abs(numbers_in<double>(file, "speed")[1] - (std::sqrt(2.0) + 0.75)) < 1e-6);
  CHECK(H5Lexists(file.id, "VTKHDF/PointData/body", H5P_DEFAULT) == 0);
}

TEST_CASE("walls follow the material, with zeros for what they do not carry and a marker") {
  Folder const folder;
  auto solver = solver_of_three<2, float>(2);
  solver.set<Wall>(rest_position, [](auto const& x) { return (x * 2).eval(); });
  BodySeries output(folder / "a.vtkhdf", Fields<Concentration, RestPosition, Identity, Pressure>{},
                    Bodies<Material, Wall>{});
  output.append(solver);
  {
    File const file(output.path());
    CHECK(file.read<double>("VTKHDF/Points") ==
          std::vector<double>{0, 0, 0, 1, 0, 0.5, 2, 0, 1, -1, 0, -1, 0, 0, -0.5});
    CHECK(numbers_in<double>(file, "concentration") == std::vector<double>{0, 0.25, 0.5, 0, 0});
    CHECK(numbers_in<double>(file, "rest_position") ==
          std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, -2, 0, -2, 0, 0, -1});
    CHECK(numbers_in<double>(file, "pressure") == std::vector<double>{-2, -12, -22, 0, 0});
    CHECK(numbers_in<std::int32_t>(file, "identity") == std::vector<std::int32_t>{0, 1, 2, 0, 1});
    CHECK(numbers_in<std::int32_t>(file, "body") == std::vector<std::int32_t>{0, 0, 0, 1, 1});
  }
  BodySeries of_wall(folder / "b.vtkhdf", Fields<RestPosition>{}, Bodies<Wall>{});
  of_wall.append(solver);
  File const file(of_wall.path());
  CHECK(file.shape("VTKHDF/Points") == Shape{2, 3});
  CHECK(numbers_in<double>(file, "rest_position") == std::vector<double>{-2, 0, -2, 0, 0, -1});
}

TEST_CASE("the groups of both bodies are written if the formulation carries them, and continue from a checkpoint") {
  struct Grouped : Case<2, double> {
    using motion = MotionOfGroups<3, Rotation>;
    using carries = Fields<Group>;
  };
  using X = Vec<2, double>;
  Folder const folder;
  auto const bed = Groups<2>().add("fine", {X(0, 0)}).add("none", {}).add("coarse", {X(1, 0), X(2, 0)});
  auto const walls = Groups<2>().add("floor", {X(0, -1), X(1, -1)}).add("blade", {X(3, 0)});
  MotionOfGroups<3, Rotation> motion(bed);  // the material follows it, too
  motion.set(walls.number("blade"), Rotation{.rate = 2});
  auto const make = [&] {
    Solver<Grouped> solver({.spacing = 0.5, .motion = motion, .start_checks = false}, bed, walls);
    solver.set(stress, [](X const&) { return Vec<4, double>(1, 2, 3, 4); });
    solver.set(concentration, [](X const& x) { return x[0]; });
    return solver;
  };
  auto solver = make(), resumed = make();
  solver.run(0.25);
  BodySeries output(folder / "a.vtkhdf", Fields<Group>{}, Bodies<Material, Wall>{});
  output.append(solver);
  File const file(output.path());
  CHECK(numbers_in<std::int32_t>(file, "group") == std::vector<std::int32_t>{0, 2, 2, 0, 0, 1});
  CHECK(file.stored_as("VTKHDF/PointData/group", H5T_STD_I32LE));
  write_checkpoint(folder / "checkpoint.h5", solver.snapshot());
  resumed.restore(read_checkpoint(folder / "checkpoint.h5"));
  solver.run(0.5), resumed.run(0.5);
  CHECK(resumed.wall().to_host(position) == solver.wall().to_host(position));
  CHECK(resumed.material().to_host(group) == std::vector<int>{0, 2, 2});
  CHECK((solver.wall().to_host(position)[2] - X(3 * std::cos(1.0), 3 * std::sin(1.0))).norm() < 1e-15);
}

TEST_CASE("a body series grows from an observer, and goes on after a restart") {
  Folder const folder;
  auto const path = folder / "a.vtkhdf";
  using Listed = Fields<Velocity, Concentration>;
  auto solver = solver_of_three<2, double>();
  using S = decltype(solver);
  Snapshot kept;
  {
    BodySeries output(path, Listed{}, Bodies<Material>{}, {.provenance = {{"case", "a test"}}});
    solver.run(1, {every<S>(0.25, [&](S& now) {
                 output.append(now);
                 if (output.steps() == 3) kept = now.snapshot();
               })});
    CHECK(output.steps() == 5);
    CHECK_THROWS_MATCHES(output.append(solver), std::invalid_argument,
                         Catch::Matchers::MessageMatches(
                             Catch::Matchers::ContainsSubstring("its time 1 is not after the last step's 1")));
  }
  CHECK(File(path).text("scree", "case") == "a test");
  auto resumed = solver_of_three<2, double>();
  resumed.restore(kept);
  auto output = BodySeries<Listed>::continued(path, resumed.time(), folder / "b.vtkhdf");
  CHECK(output.steps() == 3);
  resumed.run(1, {every<S>(0.25, [&](S& now) { output.append(now); })});
  File const whole(path), continued(output.path());
  for (auto const* name : {"Points", "PointData/velocity", "PointData/concentration", "Steps/Values"})
    CHECK(continued.read<double>(std::string("VTKHDF/") + name) == whole.read<double>(std::string("VTKHDF/") + name));
  CHECK(continued.read<double>("VTKHDF/Steps/Values") == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(continued.counts("Steps/PointOffsets") == std::vector<std::int64_t>{0, 3, 6, 9, 12});
  CHECK(continued.text("VTKHDF/PointData/velocity", "units") == "m/s");
}

TEST_CASE("a body without particles gives a step without points") {
  Folder const folder;
  auto solver = solver_of_three<3, float>(0, 0);
  BodySeries output(folder / "a.vtkhdf", Fields<Velocity, Pressure>{}, Bodies<Material, Wall>{});
  output.append(solver);
  File const file(output.path());
  CHECK(file.shape("VTKHDF/Points") == Shape{0, 3});
  CHECK(file.shape("VTKHDF/PointData/velocity") == Shape{0, 3});
  CHECK(file.shape("VTKHDF/PointData/pressure") == Shape{0});
  CHECK(file.shape("VTKHDF/PointData/body") == Shape{0});
  CHECK(file.read<double>("VTKHDF/Steps/Values") == std::vector<double>{0});
}

TEST_CASE("two fields of one name are refused before the file is written") {
  Folder const folder;
  auto solver = solver_of_three<2, double>();
  BodySeries output(folder / "a.vtkhdf", Fields<Speed, OtherSpeed>{});
  CHECK_THROWS_MATCHES(
      output.append(solver), std::invalid_argument,
      Catch::Matchers::MessageMatches(Catch::Matchers::ContainsSubstring("two fields are called 'speed'")));
  CHECK(output.steps() == 0);
}

}  // namespace scree::test::body_series_tests
