// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/wall.hpp>
#include <scree/core/pack.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::wall_tests {
namespace {

template <int Dim>
Vec<Dim, double> oblique_normal() {
  Vec<Dim, double> n;
  for (int axis = 0; axis < Dim; ++axis) n[axis] = 1 + 0.7 * axis;
  return n.normalized();
}
/// A stress whose entries all differ.
template <int Dim>
Vec<symmetric3_size<Dim>, double> some_stress() {
  Vec<symmetric3_size<Dim>, double> s;
  for (int k = 0; k < s.size(); ++k) s[k] = -3 + 1.3 * k * k;
  return s;
}
/// The reflection 1 - 2 n n of space, which does not change the direction out of the plane.
template <int Dim>
Mat<3, double> mirror(Vec<Dim, double> const& n) {
  Mat<3, double> R = Mat<3, double>::Identity();
  R.topLeftCorner<Dim, Dim>() -= 2 * n * n.transpose();
  return R;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("velocity and stress seen in a wall that lets slip are mirror images", "", ((int Dim), Dim), 2,
                       3) {
  using vector = Vec<Dim, double>;
  vector const n = oblique_normal<Dim>(), slip = vector::LinSpaced(1, 2), wall = vector::LinSpaced(-1, 3);
  auto const R = mirror<Dim>(n);
  CHECK((walls::mirrored(wall, slip, n) - (wall + R.template topLeftCorner<Dim, Dim>() * slip)).norm() < 1e-13);
  auto const sigma = some_stress<Dim>(), seen = walls::reflected(sigma, n);
  CHECK((unpacked(seen) - R * unpacked(sigma) * R).norm() < 1e-13);
  // Half way between both, the traction on the wall has no component along it.
  vector const traction = product(((sigma + seen) / 2).eval(), n);
  CHECK((traction - n.dot(traction) * n).norm() < 1e-13);
  CHECK(std::abs(n.dot(traction) - n.dot(product(sigma, n))) < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("a wall that holds turns the slip round and leaves the stress alone", "", ((int Dim), Dim), 2,
                       3) {
  using vector = Vec<Dim, double>;
  vector const slip = vector::LinSpaced(1, 2), wall = vector::LinSpaced(-1, 3), none = vector::Zero();
  CHECK(walls::mirrored(wall, slip, none) == wall - slip);
  CHECK(walls::reflected(some_stress<Dim>(), none) == some_stress<Dim>());
}

#ifdef SCREE_HAS_PACKS
TEMPLATE_TEST_CASE_SIG("walls that hold and that let slip are told apart in one pack", "", ((int Dim), Dim), 2, 3) {
  using Lanes = Pack<double>;
  Vec<Dim, Lanes> n, slip, wall;
  for (int axis = 0; axis < Dim; ++axis) {
    n[axis] = Lanes::of([&](int lane) { return lane % 2 == 0 ? 0 : oblique_normal<Dim>()[axis]; });
    slip[axis] = 1 + axis;
    wall[axis] = 3 - axis;
  }
  auto const all = walls::mirrored(wall, slip, n);
  auto const one = [](Vec<Dim, Lanes> const& x, int lane) {
    Vec<Dim, double> values;
    for (int axis = 0; axis < Dim; ++axis) values[axis] = x[axis][lane];
    return values;
  };
  for (int lane = 0; lane < Lanes::size; ++lane) {
    Vec<Dim, double> const expected = walls::mirrored(one(wall, lane), one(slip, lane), one(n, lane));
    CHECK((one(all, lane) - expected).norm() < 1e-14);
  }
}
#endif

TEST_CASE("a stress grows downwards in a wall by the weight of what could be there") {
  Vec<2, double> const weight(0, -15), offset(3, -2);
  CHECK((walls::continued(some_stress<2>(), weight, offset) - some_stress<2>()) == Vec<4, double>(0, -30, 0, 0));
}

// A layer that is the same all along a surface, in any direction: sigma n = -f y at a depth y, where n points
// downwards.
TEMPLATE_TEST_CASE_SIG("the traction of a layer is continued into its floor in any axes", "", ((int Dim), Dim), 2, 3) {
  using vector = Vec<Dim, double>;
  using Packed = Vec<symmetric3_size<Dim>, double>;
  vector const n = oblique_normal<Dim>();
  vector along = vector::UnitX() - n[0] * n;
  along = along.normalized().eval();
  for (double const steepness : {0.0, 0.1, 0.35, 0.7}) {
    vector const f = 15 * (std::cos(steepness) * n + std::sin(steepness) * along);
    auto const at_depth = [&](double y) {
      Mat<3, double> full = Mat<3, double>::Zero();
      vector const shear = f - f.dot(n) * n;
      full.topLeftCorner<Dim, Dim>() = -0.6 * f.dot(n) * y * Mat<Dim, double>::Identity() -
                                       0.4 * f.dot(n) * y * n * n.transpose() - y * (shear * n.transpose()) -
                                       y * (n * shear.transpose());
      return packed<Dim>(full);
    };
    Packed const seen = walls::extrapolated<Packed, vector>(at_depth(2), f, 0.5 * n, true);
    vector const off = product(seen, n) + 2.5 * f;
    CHECK(off.norm() < 1e-13 * 15);
  }
}

TEMPLATE_TEST_CASE_SIG("the weight adds no shear stress on a wall along gravity, or without pressure on it", "",
                       ((int Dim), Dim), 2, 3) {
  using vector = Vec<Dim, double>;
  using Packed = Vec<symmetric3_size<Dim>, double>;
  vector const n = oblique_normal<Dim>();
  vector along = (vector::UnitX() - n[0] * n).eval();
  along *= 15 / along.norm();
  auto const sigma = some_stress<Dim>();
  CHECK((walls::extrapolated<Packed, vector>(sigma, along, n, true) - sigma).norm() < 1e-13);
  // No stress, and tension: the weight adds an equal normal stress in all directions.
  Packed const tension = -walls::extrapolated<Packed, vector>(Packed::Zero(), 100 * n, n, true);
  for (int a = 0; a < Dim; ++a) CHECK(std::abs(tension[a] - 100) < 1e-13);
  CHECK(tension.tail(symmetric3_size<Dim> - 3).norm() == 0);
  Packed const pulled = walls::extrapolated<Packed, vector>(sigma + tension, n, n, true) - sigma - tension;
  CHECK(pulled.tail(symmetric3_size<Dim> - 3).norm() < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("on a wall that lets slip the weight adds normal stress only", "", ((int Dim), Dim), 2, 3) {
  using vector = Vec<Dim, double>;
  using Packed = Vec<symmetric3_size<Dim>, double>;
  vector const n = oblique_normal<Dim>();
  vector const f = 15 * n + 4 * vector::UnitX();
  auto const sigma = some_stress<Dim>(), mirror = walls::reflected(sigma, n);
  vector const traction =
      product((sigma + walls::extrapolated<Packed, vector>(mirror, f, 0.2 * n, false)).eval(), n) / 2;
  CHECK((traction - n.dot(traction) * n).norm() < 1e-13);
  CHECK(std::abs(n.dot(traction) - n.dot(product(sigma, n)) + 0.1 * f.dot(n)) < 1e-13);
}

// 5 N/m^3 along the floor and 10 across it, over 0.1 m; a layer has the ratio 1/2.
TEST_CASE("shear stress grows with the weight along a wall as far as the material in front shows that it bears it") {
  auto const grown = [](double shear, double across) {
    Vec<4, double> const sigma(-1, -1, -1, shear);
    Vec<2, double> const f(5, -across), offset(0, -0.1);
    return walls::extrapolated<Vec<4, double>, Vec<2, double>>(sigma, f, offset, true)[3] - shear;
  };
  CHECK(std::abs(grown(0.5, 10) - 0.5) < 1e-14);
  CHECK(std::abs(grown(0.4, 10) - 0.5) < 1e-14);
  CHECK(std::abs(grown(0.7, 10) - 0.5) < 1e-14);
  CHECK(std::abs(grown(0.1, 10) - 0.15) < 1e-14);
  CHECK(grown(0, 10) == 0);
  CHECK(grown(-0.5, 10) == 0);  // the other way
  CHECK(grown(0.5, -10) == 0);  // a ceiling
  CHECK(grown(0.5, 0) == 0);    // beside a bed
}

// Else the sides of a box feed an oscillation of the bed: with 8 rows of 10 mm 0.5 mm/s (rms) that do not decay.
TEST_CASE("the shear stress grows fully on slopes that a material can have, and not on walls steeper than 45 degrees") {
  auto const grown = [](double steepness) {  // f_t/f_n
    Vec<4, double> const sigma(-1, -1, -1, steepness);
    Vec<2, double> const f(5 * steepness, -5), offset(0, -0.1);
    Vec<4, double> const seen = walls::extrapolated<Vec<4, double>, Vec<2, double>>(sigma, f, offset, true);
    CHECK(std::abs(seen[1] + 1.5) < 1e-14);
    return (seen[3] - steepness) / (0.5 * steepness);
  };
  for (double const gentle : {0.1, 0.5, 0.86}) CHECK(std::abs(grown(gentle) - 1) < 1e-13);
  CHECK(std::abs(grown(std::sqrt(0.9)) - 0.4) < 1e-13);
  for (double const steep : {1.01, 1.5, 20.0}) CHECK(grown(steep) == 0);
}

}  // namespace scree::test::wall_tests
