// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "inclined.hpp"

#include <scree/granular/granular.hpp>
#include <scree/segregation/species_segregation.hpp>
#include <scree/solver/combined.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
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

struct Sorted {
  double error;  ///< largest of a row's mean over particles and time
  double lost;   ///< largest of a mean concentration
  double sum;    ///< largest distance of a sum of concentrations from 1
  double range;  ///< of the first species in the exact profile
};
/// Errors of the means over the last tenth of a time (s). Grains change places `faster` times as fast as in drums.
Sorted sorted(Slope const& slope, double faster, double time) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  Mixture const means(0.3, 0.3, 0.2, 0.2), sizes(0.6 * grain, 0.9 * grain, 1.2 * grain, 1.6 * grain);
  InProportion const closure{.v = Mixture(0.11, 0.07, 0.02, 0) * (faster * grain), .A = 0.0307 * faster * sq(grain)};
  double const dr = depth / slope.rows, length = 10 * dr;
  Sorting physics;
  physics.mechanics.law = {{.elastic = flow.law.elastic, .grains = {sizes}}};
  physics.mechanics.gravity = {g, flow.angle};
  physics.mechanics.viscosity_speed = slope.viscosity_speed;
  physics.mechanics.cfl = 0.3;
  physics.transport.closure = closure;
  Solver<GranularCase<2, Sorting>> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
                                          fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr),
                                          fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  solver.set(stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return Vec<4, double>(-p, -p, -p, std::tan(flow.angle) * p);
  });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(flow.velocity(x[1]), 0); });
  solver.set(concentrations<N>, [&](auto const&) { return means; });

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

}  // namespace scree::test::inclined::species_flow_tests
