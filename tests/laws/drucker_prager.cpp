// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/drucker_prager.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::drucker_prager_tests {
namespace {

double const degree = 3.14159265358979323846 / 180, root_3 = std::sqrt(3.0);
double const K = soft().bulk_modulus(), G = soft().shear_modulus();

// Half the difference and the compressive mean of the principal stresses in the plane.
struct InPlane {
  double radius, pressure;
};
template <class E>
InPlane in_plane(E const& element) {
  auto const& s = element.sigma;
  return {std::hypot((s[0] - s[1]) / 2, s[3]), -(s[0] + s[1]) / 2};
}
// Flow in the plane with the volume change of the angle psi: finally all strain is plastic and the stress is steady.
Element<DruckerPrager> flowing(Cone<double> const& cone, double psi) {
  Element<DruckerPrager> element{{soft(), cone}};
  element.set_pressure(300);
  Mat<2, double> L = Mat<2, double>::Zero();
  L.diagonal() << (std::sin(psi) + 1) / 2, (std::sin(psi) - 1) / 2;
  element.shear_on(L, 0.3, 60'000);
  return element;
}

}  // namespace

TEST_CASE("Drucker-Prager: cones of plane strain in closed form") {
  for (double const phi : {0.0, 20 * degree, 35 * degree}) {
    double const t = std::tan(phi), c = 70, root = std::sqrt(9 + 12 * t * t);
    auto const associated = plane_strain_cone({phi, c, phi}), isochoric = plane_strain_cone({phi, c, 0});
    CHECK(std::abs(associated.friction - 3 * t / root) < 1e-15);
    CHECK(std::abs(associated.friction - friction_ratio(t)) < 1e-15);
    CHECK(std::abs(associated.dilatancy - friction_ratio(t)) < 1e-15);
    CHECK(relative(associated.cohesion, 3 * c / root) < 1e-14);
    CHECK(std::abs(isochoric.friction - std::sin(phi)) < 1e-15);
    CHECK(relative(isochoric.cohesion, c * std::cos(phi)) < 1e-14);
    CHECK(isochoric.dilatancy == 0);
  }
  for (MohrCoulomb const wrong :
       {MohrCoulomb{-0.1, 0, 0}, MohrCoulomb{1.6, 0, 0}, MohrCoulomb{0.5, -1, 0}, MohrCoulomb{0.5, 0, -0.1},
        MohrCoulomb{0.5, 0, 0.6}, MohrCoulomb{std::nan(""), 0, 0}}) {
    CHECK_THROWS_AS(plane_strain_cone(wrong), std::invalid_argument);
    CHECK_THROWS_AS(compression_cone(wrong), std::invalid_argument);
  }
}

TEST_CASE("Drucker-Prager: flow in plane strain finds the Mohr-Coulomb line, whatever the dilatancy") {
  struct Angles {
    double phi, psi;
  };
  for (Angles const& a : {Angles{30, 30}, Angles{30, 0}, Angles{35, 10}, Angles{20, 5}})
    for (double const c : {0.0, 40.0}) {
      double const phi = a.phi * degree, psi = a.psi * degree;
      auto const cone = plane_strain_cone({phi, c, psi});
      auto const element = flowing(cone, psi);
      auto const [radius, pressure] = in_plane(element);
      CAPTURE(a.phi, a.psi, c, radius, pressure, relative(radius, pressure * std::sin(phi) + c * std::cos(phi)));
      CHECK(relative(radius, pressure * std::sin(phi) + c * std::cos(phi)) < 1e-9);
      // No flow out of the plane: the deviator there is -(2/3) k_psi sqrt(J2).
      double const out = element.sigma[2] + element.p();
      CHECK(std::abs(out + 2 * cone.dilatancy / 3 * element.tau()) < 1e-9 * element.tau());
    }
}

TEST_CASE("Drucker-Prager: simple shear at constant volume") {
  double const phi = 30 * degree, p = 100;
  Element<DruckerPrager> isochoric{{soft(), plane_strain_cone({phi, 0, 0})}};
  isochoric.set_pressure(p);
  isochoric.shear_on(simple_shear(1), 20 * p / G, 8000);
  double const S = std::sin(phi) * p;
  CHECK(relative(isochoric.sigma[3], S * std::sqrt(1 - sq(S / G))) < 1e-12);
  CHECK(relative(isochoric.p(), p) < 1e-13);
  // The paper's material at rest: k = friction_ratio(mu), no dilatancy.
  Element<DruckerPrager> paper{{soft(), {.friction = friction_ratio(0.382)}}};
  paper.set_pressure(p);
  paper.shear_on(simple_shear(1), 20 * p / G, 8000);
  CHECK(relative(paper.sigma[3] / p, 0.3495) < 1e-4);
}

TEST_CASE("Drucker-Prager: compression of one axis alone, in closed form") {
  for (Cone<double> const& cone : {Cone<double>{0.3, 20, 0}, Cone<double>{0.3, 20, 0.2}, Cone<double>{0.3, 0, 0.3}}) {
    Element<DruckerPrager, 3> element{{soft(), cone}};
    Mat<3, double> L = Mat<3, double>::Zero();
    L(2, 2) = -1;
    // sqrt(J2) = (2 G/sqrt(3)) strain meets the cone at:
    double const yields_at = cone.cohesion / (2 * G / root_3 - cone.friction * K);
    double strain = 0;
    for (double const added : {0.5 * yields_at, 0.5 * yields_at + 1e-3, 1e-3}) {
      if (added == 0) continue;
      element.shear_on(L, added, 10);
      strain += added;
      double const plastic = std::max(0.0, (2 * G / root_3 - cone.friction * K) * strain - cone.cohesion) /
                             (G + K * cone.friction * cone.dilatancy);
      double const p = K * (strain + cone.dilatancy * plastic), tau = 2 * G / root_3 * strain - G * plastic;
      CAPTURE(cone.cohesion, cone.dilatancy, strain, plastic);
      CHECK(relative(element.sigma[2], -(p + 2 * tau / root_3)) < 1e-12);
      CHECK(relative(element.sigma[0], -(p - tau / root_3)) < 1e-12);
      CHECK(relative(element.sigma[1], element.sigma[0]) < 1e-12);
    }
  }
}

TEST_CASE("Drucker-Prager: the cone of triaxial compression finds the friction angle there") {
  double const phi = 33 * degree, c = 25, p = 200;
  Element<DruckerPrager, 3> element{{soft(), compression_cone({phi, c, 0})}};
  element.set_pressure(p);
  Mat<3, double> L = Mat<3, double>::Identity() / 2;
  L(2, 2) = -1;
  element.shear_on(L, 10 * p / G, 1000);
  double const s1 = -element.sigma[2], s3 = -element.sigma[0];
  CHECK(relative(s1 - s3, (s1 + s3) * std::sin(phi) + 2 * c * std::cos(phi)) < 1e-13);
  CHECK(relative(element.p(), p) < 1e-13);
  auto const dilatant = compression_cone({phi, c, phi});
  CHECK(dilatant.dilatancy == dilatant.friction);
}

TEST_CASE("Drucker-Prager: tension ends at the tip of the cone") {
  Element<DruckerPrager> element{{soft(), plane_strain_cone({30 * degree, 40, 10 * degree})}};
  double const tip = -40 / std::tan(30 * degree);
  element.shear_on(simple_shear(0.3) + Mat<2, double>::Identity(), 0.02, 200);
  CHECK(relative(element.p(), tip) < 1e-13);
  CHECK(element.tau() < 1e-12);
}

}  // namespace scree::test::drucker_prager_tests
