// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "inclined.hpp"
#include "species_column.hpp"

#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

// Grains of four sizes in a layer that flows down a slope: shear rate, friction and concentrations found together. With
// speeds and diffusivity in proportion to the shear rate the steady concentrations do not depend on it. Figures:
// docs/theory/verification.md.
namespace scree::test::inclined::species_flow_tests {
namespace {

constexpr int N = 4;
using Mixture = Vec<N, double>;

/// S_kl = (v_k - v_l) shear_rate, D = A shear_rate, with lengths v_k (m) and A (m^2).
struct InProportion {
  static constexpr int species = N;
  Mixture v = zero<Mixture>();
  double A = 0;
  using reads = Fields<ShearRate>;
  using writes = Fields<SegregationVelocities<N>, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    double const rate = i[shear_rate];
    for_each_pair_of_species<N>(
        [&](auto k, auto l, auto pair) { out[segregation_velocities<N>][pair] = (v[k] - v[l]) * rate; });
    out[diffusivity] = A * rate;
  }
};
struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<PolydisperseGrains<N>>>;
  using volume_control = VolumeConsistency;
};
using Sorting = Combined<Granular<Models>, SpeciesSegregation<InProportion>>;

/// C_k = a_k exp(-c_k z)/sum_l a_l exp(-c_l z) with given means over a depth (m), c in 1/m.
class Softmax {
 public:
  Softmax(Mixture const& c, double depth_of_layer, Mixture const& means) : c_(c) {
    for (int k = 0; k < 2000; ++k) {
      Mixture mean = Mixture::Zero();
      for (int part = 0; part < 200; ++part) mean += (*this)((part + 0.5) / 200 * depth_of_layer) / 200;
      a_ = a_.cwiseProduct(means.cwiseQuotient(mean));
      a_ /= a_.sum();
    }
  }
  Mixture operator()(double z) const {
    Mixture C;
    for (int k = 0; k < N; ++k) C[k] = a_[k] * std::exp(-c_[k] * z);
    return C / C.sum();
  }

 private:
  Mixture c_, a_ = Mixture::Constant(1);
};

using Chute = Solver<GranularCase<2, Sorting, double, SymplecticEuler>>;
Mixture const alike = Mixture::Constant(grain), sizes(0.6 * grain, 0.9 * grain, 1.2 * grain, 1.6 * grain);

/// Grains of these diameters (m) in the law, with a mixture that is a function of the place.
template <class Start>
Chute chute(Slope const& slope, double length, Mixture const& in_law, InProportion const& closure, Start const& start) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  double const dr = depth / slope.rows;
  Sorting physics;
  physics.mechanics.law = {{.elastic = flow.law.elastic, .grains = {in_law}}};
  physics.mechanics.gravity = {g, flow.angle};
  physics.mechanics.viscosity_speed = slope.viscosity_speed;
  physics.mechanics.cfl = 0.6;
  physics.transport.closure = closure;
  Chute solver({.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
               fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  solver.set(stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return Vec<4, double>(-p, -p, -p, std::tan(flow.angle) * p);
  });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(flow.velocity(x[1]), 0); });
  solver.set(concentrations<N>, [&](auto const& x) { return Mixture(start(x)); });
  return solver;
}
/// Grains change places `faster` times as fast as in drums.
InProportion closure_of(double faster) {
  return {.v = Mixture(0.11, 0.07, 0.02, 0) * (faster * grain), .A = 0.0307 * faster * sq(grain)};
}

struct Sorted {
  double error;  ///< largest of a row's mean over particles and time
  double lost;   ///< largest of a mean concentration
  double sum;    ///< largest distance of a sum of concentrations from 1
  double range;  ///< of the first species in the exact profile
};
/// Errors of the means over the last tenth of a time (s).
Sorted sorted(Slope const& slope, double faster, double time) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  Mixture const means(0.3, 0.3, 0.2, 0.2);
  InProportion const closure = closure_of(faster);
  auto solver = chute(slope, 10 * depth / slope.rows, sizes, closure, [&](auto const&) { return means; });

  std::vector<Mixture> sum(std::size_t(slope.rows), Mixture::Zero());
  std::vector<double> number(sum.size());
  std::optional<Softmax> expected;
  Sorted found{};
  for (int k = 0; k <= 100; ++k) {
    solver.run((0.9 + 0.001 * k) * time);
    auto const x = solver.material().to_host(position);
    auto const C = solver.material().to_host(concentrations<N>);
    if (k == 0) {
      double height = 0;
      for (auto const& each : x) height += 2 * each[1] / double(x.size());
      // Grains segregate along gravity, not along the normal of the slope.
      expected.emplace(closure.v * (std::cos(flow.angle) / closure.A), height, means);
      found.range = (*expected)(0)[0] - (*expected)(height)[0];
    }
    Mixture total = Mixture::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const row = std::size_t(std::clamp(int(x[i][1] / depth * slope.rows), 0, slope.rows - 1));
      sum[row] += C[i] - (*expected)(x[i][1]), number[row] += 1;
      total += C[i] / double(x.size());
      found.sum = std::max(found.sum, std::abs(C[i].sum() - 1));
    }
    found.lost = (total - means).cwiseAbs().maxCoeff();
  }
  for (std::size_t k = 0; k < sum.size(); ++k)
    found.error = std::max(found.error, sum[k].cwiseAbs().maxCoeff() / std::max(number[k], 1.0));
  UNSCOPED_INFO(slope.angle << " degrees, " << slope.rows << " rows, " << faster << " times as fast, " << time
                            << " s: error " << found.error << " of " << found.range << ", lost " << found.lost
                            << ", sums off by " << found.sum << ", speed "
                            << mean_velocity(solver) / (0.6 * exact(slope).velocity(depth)));
  show_packing(solver);
  return found;
}

/// N species in a layer of unit width that flows steadily, over its depth (m) by finite volumes: the flux of Rusanov
/// (1961) and central differences for the diffusion. The shear rate is that of friction which balances the weight: I
/// is uniform, and the shear rate I sqrt(p/rho_s) over the mean diameter.
class Layer {
 public:
  Layer(int cells, Bagnold const& flow, Mixture const& diameters, InProportion const& closure,
        std::function<Mixture(double)> const& start)
      : flow_(flow), d_(diameters), closure_(closure), dz_(flow.depth / cells) {
    for (int c = 0; c < cells; ++c) C_.push_back(start((c + 0.5) * dz_));
  }
  void run(double until) {
    std::vector<Mixture> flux(C_.size() + 1, Mixture::Zero());  // upwards
    double const fastest = closure_.v.maxCoeff() - closure_.v.minCoeff();
    while (time_ < until * (1 - 1e-12)) {
      double most = 0;
      for (std::size_t c = 0; c < C_.size(); ++c) most = std::max(most, shear_rate(c * dz_, C_[c]));
      double const dt = std::min({0.4 * dz_ / (fastest * most), 0.2 * sq(dz_) / (closure_.A * most), until - time_});
      for (std::size_t c = 1; c < C_.size(); ++c) {
        double const z = double(c) * dz_, below = shear_rate(z, C_[c - 1]), above = shear_rate(z, C_[c]);
        double const speed = fastest * std::max(below, above);
        flux[c] = (sinking(C_[c - 1]) * below + sinking(C_[c]) * above) / 2 -
                  (speed / 2 + closure_.A * (below + above) / 2 / dz_) * (C_[c] - C_[c - 1]);
      }
      for (std::size_t c = 0; c < C_.size(); ++c) C_[c] -= dt / dz_ * (flux[c + 1] - flux[c]);
      time_ += dt;
    }
  }
  Mixture mean(double low, double high) const { return mean_between(C_, dz_, low, high); }

 private:
  double shear_rate(double z, Mixture const& C) const {
    return flow_.inertial_number() * std::sqrt(flow_.pressure(z) / flow_.law.grain_density) / mean_of_species(C, d_);
  }
  /// The flux over the shear rate without diffusion; gravity is not normal to the layer.
  Mixture sinking(Mixture const& C) const {
    Mixture const along = C.cwiseProduct((closure_.v.array() - closure_.v.dot(C)).matrix());
    return -std::cos(flow_.angle) * along;
  }

  Bagnold flow_;
  Mixture d_;
  InProportion closure_;
  double dz_, time_ = 0;
  std::vector<Mixture> C_;
};

/// Small grains on top, large ones below; the fourth size is absent.
Mixture inverted(double share) {
  return {share > 2.0 / 3 ? 1.0 : 0.0, share > 1.0 / 3 && share < 2.0 / 3 ? 1.0 : 0.0, share < 1.0 / 3 ? 1.0 : 0.0, 0};
}
struct Overturned {
  double error = 0;      ///< of the means of rows over the times: half the sum over the sizes, spacings
  double reference = 0;  ///< difference of finite volumes from those with half as many cells, spacings
  double wave = 0;       ///< largest amplitude of the wave of the amount of small grains over its start
  double last_wave = 0;
  double sorted = 0;  ///< at the end: C of the first size in the lowest row less that in the highest
};
/// Grains have the diameters `in_law` (m) in the friction. Layers in inverted order whose borders are one wave over the
/// length, of an amplitude over the depth. With a wave the finite volumes start from the mean over the length, which
/// does not sink as the waves do.
Overturned overturn(Slope const& slope, Mixture const& in_law, double faster, double time, double length_over_depth,
                    double wave) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  double const dr = depth / slope.rows, length = length_over_depth * depth, k = 2 * std::numbers::pi / length;
  InProportion const closure = closure_of(faster);
  auto solver = chute(slope, length, in_law, closure,
                      [&](auto const& x) { return inverted(x[1] / depth + wave * std::cos(k * x[0])); });
  // Rows of the mean over the length at the start.
  auto const start = [&](double z) {
    Mixture mean = Mixture::Zero();
    for (int n = 0; n < 200; ++n) mean += inverted(z / depth + wave * std::cos(2 * std::numbers::pi * n / 200)) / 200;
    return mean;
  };
  Layer coarse(8 * slope.rows, flow, in_law, closure, start), fine(16 * slope.rows, flow, in_law, closure, start);
  auto const rows_of = [&] {
    auto const x = solver.material().to_host(position);
    auto const C = solver.material().to_host(concentrations<N>);
    // In the order of their heights, because the layer is a little thinner than at the start.
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return x[i][1]; });
    std::vector<Mixture> rows(std::size_t(slope.rows), Mixture::Zero());
    for (std::size_t n = 0; n < order.size(); ++n)
      rows[n * rows.size() / order.size()] += C[order[n]] * (double(rows.size()) / double(order.size()));
    return rows;
  };
  auto const wave_of = [&] {
    auto const x = solver.material().to_host(position);
    auto const C = solver.material().to_host(concentrations<N>);
    double c = 0, s = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      c += C[i][0] * std::cos(k * x[i][0]), s += C[i][0] * std::sin(k * x[i][0]);
    return std::hypot(c, s);
  };
  double const first = wave_of();
  Overturned found;
  for (int part = 1; part <= 20; ++part) {
    double const now = time * part / 20;
    solver.run(now), coarse.run(now), fine.run(now);
    auto const rows = rows_of();
    double error = 0, difference = 0;
    for (int row = 0; row < slope.rows; ++row) {
      Mixture const expected = fine.mean(row * dr, (row + 1) * dr);
      error += (rows[std::size_t(row)] - expected).cwiseAbs().sum() / 2;
      difference += (coarse.mean(row * dr, (row + 1) * dr) - expected).cwiseAbs().sum() / 2;
    }
    found.error = std::max(found.error, error), found.reference = std::max(found.reference, difference);
    if (wave > 0) found.last_wave = wave_of() / first;
    found.wave = std::max(found.wave, found.last_wave);
    found.sorted = rows.front()[0] - rows.back()[0];
    UNSCOPED_INFO("  at " << now << " s off by " << error << " spacings, wave " << found.last_wave << ", speed "
                          << mean_velocity(solver) / (0.6 * flow.velocity(depth)));
  }
  UNSCOPED_INFO(slope.angle << " degrees, " << slope.rows << " rows, " << faster << " times as fast: off by "
                            << found.error << " spacings, finite volumes by " << found.reference << "; wave at most "
                            << found.wave << ", at the end " << found.last_wave << "; sorted " << found.sorted);
  show_packing(solver);
  return found;
}

}  // namespace

TEST_CASE("grains of four sizes find their equilibrium in a flow down a slope") {
  auto const found = sorted({.angle = 24}, 30, 0.25);
  CHECK(found.error < 0.03);
  CHECK(found.range > 0.5);
  CHECK(found.lost < 1e-12);
  CHECK(found.sum < 1e-11);
}
TEST_CASE("grains of four sizes find their equilibrium in a flow down a slope, finer", "[.long]") {
  for (double const angle : {22.0, 24.0}) {
    auto const fine = sorted({.angle = angle, .rows = 40}, 30, angle == 22 ? 1 : 0.5);
    CHECK(fine.error < 0.01);
    CHECK(fine.lost < 1e-12);
    CHECK(fine.sum < 1e-11);
  }
}

// Sizes enter the flow by the mean diameter in the law alone, docs/theory/segregation.md.
TEST_CASE("where the law does not read the sizes, layers of grains leave no trace in the flow") {
  auto const after = [](Mixture const& in_law, auto const& start) {
    auto solver = chute({.angle = 24, .rows = 10}, depth, in_law, closure_of(30), start);
    solver.run(0.05);
    show_packing(solver);
    return solver.material().to_host(fields::position);
  };
  auto const mixed = [](auto const&) { return Mixture(0.4, 0.3, 0.3, 0); };
  auto const layers = [](auto const& x) { return inverted(x[1] / depth); };
  auto const apart = [](auto const& a, auto const& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(Vec<2, double>(a[i] - b[i])) / depth);
    return most;
  };
  double const by_rounding = apart(after(alike, mixed), after(alike, layers));  // of the mean diameter
  double const by_size = apart(after(sizes, mixed), after(sizes, layers));
  INFO("places differ by " << by_rounding << " and " << by_size << " of the depth");
  CHECK(by_rounding < 1e-9);
  CHECK(by_size > 1e-3);
}

TEST_CASE("three layers in inverted order change places in a flow down a slope") {
  auto const found = overturn({.angle = 24, .rows = 12}, sizes, 30, 0.21, 0.5, 0);
  CHECK(found.error < 2);
  CHECK(found.reference < 0.5);
  CHECK(found.sorted > 0.9);
}
TEST_CASE("three layers in inverted order change places in a flow down a slope, finer", "[.long]") {
  for (int const rows : {20, 40})
    for (Mixture const& in_law : {alike, sizes}) {
      auto const found = overturn({.angle = 24, .rows = rows}, in_law, 10, 0.8, 10.0 / rows, 0);
      CHECK(found.error < 2);
      CHECK(found.sorted > 0.9);
    }
}
// Small grains above large ones start to sink everywhere, and nothing makes a wave of their border grow.
TEST_CASE("a wave of the border of layers in inverted order decays at any spacing", "[.long]") {
  for (int const rows : {10, 20, 40}) {
    auto const found = overturn({.angle = 24, .rows = rows}, sizes, 10, 0.16, 2, 0.1);
    CHECK(found.wave < 1);
    CHECK(found.last_wave < 0.2);
  }
}

}  // namespace scree::test::inclined::species_flow_tests
