// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/wall.hpp>
#include <scree/core/pack.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test {
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

}  // namespace scree::test
