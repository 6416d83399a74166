// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The two-dimensional reference against a method that shares nothing with it: spectral elements (degree 8,
// Gauss-Lobatto nodes, lumped mass, classical Runge-Kutta) for the weak form  d/dt int C v = int j . grad v  of the
// physical fluxes, in which the no-flux walls need no treatment at all.

#include "../../../../examples/shear_box/reference/finite_volume_2d.hpp"

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace scree::test::spectral_elements_tests {
using namespace shear_box::reference;

namespace {

constexpr int degree = 8, nodes = degree + 1;

double legendre(double x) {
  double before = 1.0, value = x;
  for (int k = 2; k <= degree; ++k) {
    double const next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return value;
}

struct GaussLobatto {
  std::array<double, nodes> x{}, weight{};
  std::array<std::array<double, nodes>, nodes> derivative{};

  GaussLobatto() {
    x = {-1.0, -0.899757995411460, -0.677186279510738, -0.363117463826178,
         0.0,  0.363117463826178,  0.677186279510738,  0.899757995411460,
         1.0};
    for (int i = 0; i < nodes; ++i) {
      weight[i] = 2.0 / (degree * nodes * legendre(x[i]) * legendre(x[i]));
      for (int j = 0; j < nodes; ++j)
        if (i != j) derivative[i][j] = legendre(x[i]) / legendre(x[j]) / (x[i] - x[j]);
    }
    derivative[0][0] = -0.25 * degree * nodes;
    derivative[degree][degree] = 0.25 * degree * nodes;
  }
};

class SpectralElements {
 public:
  SpectralElements(Problem<> const& problem, int across, int along)
      : problem_(problem),
        across_(across),
        along_(along),
        nx_(across * degree + 1),
        nz_(along * degree + 1),
        hx_(problem.width / across),
        hz_(1.0 / along),
        C(nx_ * nz_),
        mass_(C.size(), 0.0) {
    for (int j = 0; j < nz_; ++j)  // the interface lies between two elements (along is even)
      for (int i = 0; i < nx_; ++i) C[j * nx_ + i] = 2 * j < nz_ - 1 ? 0.0 : (2 * j > nz_ - 1 ? 1.0 : 0.5);
    for_each_node([&](int node, int i, int j) { mass_[node] += quadrature(i, j); });
  }

  void advance(double until, double dt) {
    long const steps = std::lround(until / dt);
    for (long n = 0; n < steps; ++n) {
      double const t = n * dt;
      auto const k1 = rate(C, t);
      auto const k2 = rate(sum(C, 0.5 * dt, k1), t + 0.5 * dt);
      auto const k3 = rate(sum(C, 0.5 * dt, k2), t + 0.5 * dt);
      auto const k4 = rate(sum(C, dt, k3), t + dt);
      for (std::size_t i = 0; i < C.size(); ++i) C[i] += dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
  }

  // Mean of |C - field| over the nodes, weighted by the area of each.
  double mean_absolute_difference(Field2d const& field) const {
    double difference = 0.0;
    for (int e = 0; e < across_ * along_; ++e)
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
          double const X = (e % across_ + 0.5 * (1.0 + gll_.x[i])) * hx_;
          double const Z = (e / across_ + 0.5 * (1.0 + gll_.x[j])) * hz_;
          difference += quadrature(i, j) * std::abs(C[node(e, i, j)] - field(X, Z));
        }
    return difference / problem_.width;
  }

 private:
  using Element = std::array<std::array<double, nodes>, nodes>;

  int node(int e, int i, int j) const { return (e / across_ * degree + j) * nx_ + e % across_ * degree + i; }
  double quadrature(int i, int j) const { return 0.25 * gll_.weight[i] * gll_.weight[j] * hx_ * hz_; }

  template <class F>
  void for_each_node(const F& f) const {
    for (int e = 0; e < across_ * along_; ++e)
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) f(node(e, i, j), i, j);
  }

  static std::vector<double> sum(std::vector<double> a, double factor, std::vector<double> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
    return a;
  }

  std::vector<double> rate(std::vector<double> const& c, double t) const {
    std::vector<double> result(c.size(), 0.0);
    for (int e = 0; e < across_ * along_; ++e) add_element(c, e, problem_.shear(t), result);
    for (std::size_t i = 0; i < c.size(); ++i) result[i] /= mass_[i];
    return result;
  }

  void add_element(std::vector<double> const& c, int e, double gamma, std::vector<double>& result) const {
    Element local, flow_X, flow_Z;  // j . grad of X = x - gamma z and of Z = z, times quadrature
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i) local[j][i] = c[node(e, i, j)];
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i) {
        double C_X = 0.0, C_Z = 0.0;
        for (int k = 0; k < nodes; ++k) {
          C_X += gll_.derivative[i][k] * local[j][k] * 2.0 / hx_;
          C_Z += gll_.derivative[j][k] * local[k][i] * 2.0 / hz_;
        }
        double const D = problem_.closure.mean.diffusivity;
        double const j_x = -D * C_X;
        double const j_z = -problem_.percolation(local[j][i]) - D * (C_Z - gamma * C_X);
        flow_X[j][i] = quadrature(i, j) * 2.0 / hx_ * (j_x - gamma * j_z);
        flow_Z[j][i] = quadrature(i, j) * 2.0 / hz_ * j_z;
      }
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i) {
        double flow = 0.0;
        for (int k = 0; k < nodes; ++k)
          flow += gll_.derivative[k][i] * flow_X[j][k] + gll_.derivative[k][j] * flow_Z[k][i];
        result[node(e, i, j)] += flow;
      }
  }

  GaussLobatto gll_;
  Problem<> problem_;
  int across_, along_, nx_, nz_;
  double hx_, hz_;
  std::vector<double> C, mass_;
};

}  // namespace

TEST_CASE("finite volumes 2D: extrapolated field equals that of spectral elements") {
  for (SegregationFlux const flux : {symmetric_flux, asymmetric_flux}) {
    Problem<> const problem{.flux = flux};
    SpectralElements elements(problem, 4, 12);
    elements.advance(20.0, 0.0025);
    double const coarse = elements.mean_absolute_difference(solve_2d_extrapolated(problem, {20.0}, 0.01)[0]);
    double const fine = elements.mean_absolute_difference(solve_2d_extrapolated(problem, {20.0}, 0.005)[0]);
    INFO("mean absolute difference: " << coarse << " (spacing 0.01), " << fine << " (0.005)");
    CHECK(coarse < 2e-4);
    CHECK(fine < 3e-5);
  }
}

}  // namespace scree::test::spectral_elements_tests
