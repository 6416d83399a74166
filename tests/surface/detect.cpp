// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/surface/detect.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>
#include <numeric>
#include <random>

namespace scree::test::detect_tests {
using namespace fields;
namespace {

template <class P>
using Detecting = Formulated<P, NothingEvolves, AtRest, SurfaceDetection>;

template <class P>
struct Found {
  using vector = Vec<P::dim, typename P::real>;
  std::vector<vector> x;
  std::vector<int> sets;
  std::vector<vector> free_normals, wall_normals;
};

template <class P>
Found<P> detect(Bed<P::dim> const& bed, double spacing) {
  auto solver = solver_of<Detecting<P>>(bed, spacing);
  solver.update_diagnostics();
  auto const& material = solver.material();
  return {material.to_host(position), material.to_host(surface_set), material.to_host(free_surface_normal),
          material.to_host(wall_normal)};
}

double const dr = 0.1;

/// Number of the lattice row or column of a coordinate.
int row_of(double coordinate) { return static_cast<int>(std::floor(coordinate / dr + 1e-6)); }

/// The sets that follow from the definitions for a bed of n^(dim - 1) columns and n rows between walls, where h = 1.5
/// dr and the support is 3 dr: walls are within the support of the two outer rows (the third touches it); Omega_f is
/// closer than 2h - dr = 2 dr to Omega_F. Nothing covers the particle where the free surface meets a side wall: its
/// umbrella leans away from the wall.
template <int Dim, class X>
int expected_set(X const& x, int n) {
  int const height = row_of(double(x[Dim - 1])), from_top = n - 1 - height;
  int to_side = n;
  for (int axis = 0; axis < Dim - 1; ++axis) {
    int const column = row_of(double(x[axis]));
    to_side = std::min({to_side, column, n - 1 - column});
  }
  int const to_wall = std::min(to_side, height);
  int set = surface::interior;
  if (from_top <= 1) set |= from_top == 0 ? surface::free : surface::near_free;
  if (to_wall <= 1) set |= to_wall == 0 && from_top > 0 ? surface::wall : surface::near_wall;
  return set;
}

/// Shears a bed by the tangent of 30 degrees, as walls at their largest inclination do.
Bed<2> sheared(Bed<2> bed) {
  double const shear = std::tan(std::numbers::pi / 6);
  for (auto& x : bed.material) x[0] += shear * x[1];
  for (auto& x : bed.wall) x[0] += shear * x[1];
  return bed;
}

}  // namespace

TEST_CASE("the umbrella is a cone of 45 degrees and a sphere at its end") {
  struct Neighbour {
    Vec<2, double> x;
    double r = x.norm();
    double h() const { return 0.3; }
  };
  auto const covers = [](double distance, double degrees) {  // distance over h, angle from the inward direction
    double const a = degrees * std::numbers::pi / 180;
    Vec<2, double> const inward(0.6, 0.8), across(-0.8, 0.6);
    return surface::in_umbrella(Neighbour{distance * 0.3 * (std::cos(a) * inward + std::sin(a) * across)}, inward);
  };
  for (double const side : {-1.0, 1.0}) {
    for (double const distance : {0.1, 1.0, 1.4, 1.45}) {
      CHECK(covers(distance, side * 42));
      CHECK_FALSE(covers(distance, side * 48));
    }
    CHECK(covers(1.7, side * 30));  // the sphere ends at 2 cos(angle)
    CHECK_FALSE(covers(1.8, side * 30));
  }
  CHECK(covers(1.95, 0));
  CHECK_FALSE(covers(2.05, 0));
  CHECK_FALSE(covers(1, 180));
}

TEMPLATE_LIST_TEST_CASE("the sets of a bed between walls are its outer rows", "", Policies) {
  using P = TestType;
  int const n = 9;
  auto const found = detect<P>(open_bed<P::dim>(Vec<P::dim, double>::Constant(n * dr), dr), dr);
  int wrong = 0;
  for (std::size_t i = 0; i < found.x.size(); ++i)
    if (found.sets[i] != expected_set<P::dim>(found.x[i], n)) {
      if (++wrong == 1)
        UNSCOPED_INFO("at " << found.x[i].transpose() << ": " << found.sets[i] << " instead of "
                            << expected_set<P::dim>(found.x[i], n));
    }
  CHECK(wrong == 0);
}

TEMPLATE_LIST_TEST_CASE("normals of straight boundaries are exact away from corners and point inwards", "", Policies) {
  using P = TestType;
  int const n = 9, up = P::dim - 1;
  using vector = Vec<P::dim, typename P::real>;
  auto const found = detect<P>(open_bed<P::dim>(Vec<P::dim, double>::Constant(n * dr), dr), dr);
  int seen_free = 0, seen_floor = 0, seen_side = 0;
  for (std::size_t i = 0; i < found.x.size(); ++i) {
    int rows[P::dim];
    bool central = true;  // four columns away from the walls
    for (int axis = 0; axis < P::dim; ++axis) rows[axis] = row_of(double(found.x[i][axis]));
    for (int axis = 0; axis < up; ++axis) central = central && rows[axis] == 4;
    // Sums of about 30 terms that cancel to round-off.
    double const close = ulps<P>(100);
    if (central && rows[up] >= n - 2) {
      ++seen_free;
      CHECK((found.free_normals[i] + vector::Unit(up)).norm() < close);
      CHECK(found.wall_normals[i].norm() == 0);
    }
    if (central && rows[up] <= 1) {
      ++seen_floor;
      CHECK((found.wall_normals[i] - vector::Unit(up)).norm() < close);
      CHECK(found.free_normals[i].norm() == 0);
    }
    bool along = rows[up] == 4;
    for (int axis = 1; axis < up; ++axis) along = along && rows[axis] == 4;
    if (along && (rows[0] <= 1 || rows[0] >= n - 2)) {
      ++seen_side;
      CHECK((found.wall_normals[i] - (rows[0] <= 1 ? 1 : -1) * vector::Unit(0)).norm() < close);
    }
    if (found.sets[i] == surface::interior) CHECK(found.free_normals[i].norm() == 0);
  }
  CHECK(seen_free == 2);
  CHECK(seen_floor == 2);
  CHECK(seen_side == 4);
}

TEMPLATE_LIST_TEST_CASE("normals in corners lie between those of the sides", "", DoublePolicies) {
  using P = TestType;
  int const n = 9, up = P::dim - 1;
  auto const found = detect<P>(open_bed<P::dim>(Vec<P::dim, double>::Constant(n * dr), dr), dr);
  // Floor and side wall are equivalent: the diagonal, also for the corner of three walls.
  auto const expected = (Vec<P::dim, double>::Ones() / std::sqrt(double(P::dim))).eval();
  CHECK((found.wall_normals[0] - expected).norm() < 1e-13);
  // The corner of side wall and free surface, where the wall continues above: the wall's normal is that of the wall
  // alone.
  for (std::size_t i = 0; i < found.x.size(); ++i) {
    if (row_of(found.x[i][up]) != n - 1 || row_of(found.x[i][0]) != 0) continue;
    if (P::dim == 3 && row_of(found.x[i][1]) != 4) continue;
    CHECK((found.wall_normals[i] - Vec<P::dim, double>::Unit(0)).norm() < 1e-13);
    CHECK(found.free_normals[i].dot(-Vec<P::dim, double>::Unit(up)) > 0);
  }
}

TEMPLATE_LIST_TEST_CASE("a disc is free all round", "", DoublePolicies) {
  using P = TestType;
  double const radius = 1.5;
  Bed<P::dim> bed;
  for (auto const& x :
       fill_lattice(Box<P::dim>{Vec<P::dim, double>::Constant(-2), Vec<P::dim, double>::Constant(2)}, 0.125))
    if (x.norm() < radius) bed.material.push_back(x);
  auto const found = detect<P>(bed, 0.125);
  int missing = 0, false_alarms = 0;
  double largest_angle = 0;
  for (std::size_t i = 0; i < found.x.size(); ++i) {
    double const depth = radius - found.x[i].norm();
    int const set = found.sets[i];
    CHECK((set & (surface::wall | surface::near_wall)) == 0);
    // A cut lattice has steps of up to one spacing; Omega_f reaches 2 dr further.
    if (depth < 0.5 * 0.125) missing += set == surface::interior;
    if (depth > 4 * 0.125) false_alarms += set != surface::interior;
    if (!(set & surface::free)) continue;
    double const cosine = -found.free_normals[i].dot(found.x[i]) / found.x[i].norm();
    largest_angle = std::max(largest_angle, std::acos(std::min(1.0, cosine)));
  }
  CHECK(missing == 0);
  CHECK(false_alarms == 0);
  // A step of one spacing within the support of three.
  INFO("largest angle " << largest_angle * 180 / std::numbers::pi << " degrees");
  CHECK(largest_angle < std::atan(1.0 / 3));
}

TEST_CASE("a sheared bed has the sets of the upright one and inclined normals") {
  using std::numbers::pi;
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  int const n = 12;
  auto const upright = open_bed<2>({n * dr, n * dr}, dr);
  auto const found = detect<P>(sheared(upright), dr);
  double const incline = pi / 6;
  Vec<2, double> const from_left(std::cos(incline), -std::sin(incline));
  for (std::size_t i = 0; i < found.x.size(); ++i) {
    int const column = row_of(upright.material[i][0]), row = row_of(upright.material[i][1]);
    int const to_side = std::min(column, n - 1 - column), from_top = n - 1 - row;
    INFO("column " << column << ", row " << row);
    int const set = found.sets[i];
    if ((to_side == 0 && from_top > 1) || row == 0) CHECK((set & surface::wall) != 0);
    if (from_top == 0 && to_side > 2) CHECK((set & surface::free) != 0);
    if (to_side > 4 && row > 3 && from_top > 3) CHECK(set == surface::interior);
    // Away from corners the lattice is the same all along a side; the sheared one has no mirror symmetry, so that a
    // normal may be off by a fraction of the angle between lattice rows, 30 degrees.
    if (to_side <= 1 && row > 3 && from_top > 3)
      CHECK(found.wall_normals[i].dot(column <= 1 ? from_left : -from_left) > std::cos(pi / 18));
    if (from_top == 0 && to_side > 4) CHECK(-found.free_normals[i][1] > std::cos(pi / 18));
    if (row == 0 && to_side > 4) CHECK(found.wall_normals[i][1] > std::cos(pi / 18));
  }
}

TEMPLATE_LIST_TEST_CASE("sets and normals do not depend on where the bed is nor on the order of its particles", "",
                        DoublePolicies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(Vec<P::dim, double>::Constant(0.9), dr);
  jitter(bed.material, 0.2 * dr, 6);
  auto const found = detect<P>(bed, dr);

  auto elsewhere = bed;
  for (auto* points : {&elsewhere.material, &elsewhere.wall})
    for (auto& x : *points) x += Vec<P::dim, double>::LinSpaced(P::dim, 7.31, -3.77);
  CHECK(detect<P>(elsewhere, dr).sets == found.sets);

  std::vector<std::size_t> order(bed.material.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  auto shuffled = bed;
  for (std::size_t k = 0; k < order.size(); ++k) shuffled.material[k] = bed.material[order[k]];
  auto const again = detect<P>(shuffled, dr);
  int wrong = 0;
  double error = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    wrong += again.sets[k] != found.sets[order[k]];
    error = std::max(error, (again.free_normals[k] - found.free_normals[order[k]]).norm());
  }
  CHECK(wrong == 0);
  CHECK(error < 1e-10);
}

TEST_CASE("sets of a lattice do not depend on rounding") {
  // At rest many distances are exactly a radius; the position of the bed must not decide on which side of it they fall.
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto const bed = open_bed<2>({0.9, 0.9}, dr);
  auto const found = detect<P>(bed, dr);
  for (double const shift : {0.317, -4.1, 12.0}) {
    auto elsewhere = bed;
    for (auto* points : {&elsewhere.material, &elsewhere.wall})
      for (auto& x : *points) x.array() += shift;
    CHECK(detect<P>(elsewhere, dr).sets == found.sets);
  }
}

}  // namespace scree::test::detect_tests
