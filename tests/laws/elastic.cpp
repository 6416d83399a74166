// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/mu_of_i.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Geometry>

#include <numbers>

namespace scree::test::elastic_tests {
namespace {

struct Rotated {
  Mat<3, double> start, end;
};
// A stress within yield that rotates rigidly about an axis.
template <class Law>
Rotated rotate(Law const& law, Eigen::Vector3d const& axis, double turns, int steps) {
  Element<Law, 3> element{law};
  element.sigma << -100, -130, -90, 12, -7, 9;
  Mat<3, double> L;
  L << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  Mat<3, double> const start = unpacked(element.sigma);
  element.shear_on(2 * std::numbers::pi * L, turns, steps);
  return {start, unpacked(element.sigma)};
}

}  // namespace

TEST_CASE("elastic: moduli and wave speed") {
  Elastic const law{.young = 1e7, .poisson = 0.3, .rest_density = 1500};
  CHECK(relative(law.bulk_modulus(), 1e7 / 1.2) < 1e-14);
  CHECK(relative(law.shear_modulus(), 1e7 / 2.6) < 1e-14);
  CHECK(relative(law.sound_speed(), 94.7) < 1e-3);
  CHECK(relative(soft().sound_speed(), 10) < 1e-4);
}

TEST_CASE("elastic: in an oedometer the stress on the sides is nu/(1 - nu) of that on top") {
  Elastic const law = soft();
  Mat<2, double> L = Mat<2, double>::Zero();
  L(1, 1) = -1;
  Element<Elastic, 2> element{law};
  element.shear_on(L, 1e-3, 10);
  double const modulus = law.rest_density * sq(law.sound_speed());
  CHECK(relative(element.sigma[1], -1e-3 * modulus) < 1e-13);
  CHECK(relative(element.sigma[0] / element.sigma[1], 0.3 / 0.7) < 1e-13);
  CHECK(relative(element.sigma[2] / element.sigma[1], 0.3 / 0.7) < 1e-13);
  CHECK(element.sigma[3] == 0);
}

TEST_CASE("elastic: a stress turns with the material") {
  // A tenth of a turn about z: sigma -> R sigma R^T.
  Eigen::Vector3d const axis(0, 0, 1);
  auto const turned = rotate(soft(), axis, 0.1, 4000);
  Eigen::Matrix3d const R = Eigen::AngleAxisd(0.2 * std::numbers::pi, axis).toRotationMatrix();
  CHECK((turned.end - R * turned.start * R.transpose()).norm() < 1e-7 * turned.start.norm());
}

TEST_CASE("elastic: a hundred turns leave the stress and its invariants, to second order of the step") {
  Eigen::Vector3d const upright(0, 0, 1), oblique = Eigen::Vector3d(1, -2, 3).normalized();
  MuOfI<> const granular{.elastic = soft(), .grains = {5e-4}};
  for (auto const& axis : {upright, oblique}) {
    auto const coarse = rotate(granular, axis, 100, 100'000), fine = rotate(granular, axis, 100, 200'000);
    double const error = (coarse.end - coarse.start).norm(), less = (fine.end - fine.start).norm();
    CAPTURE(axis.transpose(), error / coarse.start.norm(), error / less);
    CHECK(std::abs(error / less - 4) < 0.05);
    CHECK(relative(pressure_of(coarse.end), pressure_of(coarse.start)) < 1e-11);
    // In the plane of rotation the step multiplies the deviator by |1 + i theta - theta^2/2|, theta = 4 pi/1000.
    double const growth = std::pow(1 + std::pow(4 * std::numbers::pi / 1000, 4) / 4, 50'000) - 1;
    auto const tau_of = [](auto const& sigma) { return equivalent_shear_stress(deviator_of(sigma)); };
    double const drift = tau_of(coarse.end) / tau_of(coarse.start) - 1;
    CAPTURE(drift, growth);
    CHECK(std::abs(drift) < 1.001 * growth);
    CHECK(growth < 3.2e-4);
    CHECK(std::abs(tau_of(fine.end) / tau_of(fine.start) - 1) < drift / 7.9);
  }
}

}  // namespace scree::test::elastic_tests
