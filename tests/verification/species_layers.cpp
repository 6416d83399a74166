// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "species_column.hpp"

#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/kinetic_stress_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// Three species in a layer of height 1 at rest, layers in inverted order without diffusion against finite
// volumes, and the equilibrium of a closure whose speeds do not add up. Figures: docs/theory/verification.md.
namespace scree::test::species_layers_tests {
using namespace fields;
namespace {

using Mixture = Vec<3, double>;
using Plane = Policy<2, double, Kokkos::DefaultExecutionSpace>;
int const width = 7;  // spacings; a period is longer than two supports

/// A layer that is periodic along the first coordinate, on a floor.
template <class Physics>
struct Layer {
  double dr;
  int rows;
  std::vector<double> heights;
  Solver<Formulated<Plane, Physics>> solver;

  template <class Start>
  Layer(int count, double jittered, Physics const& physics, Start const& start)
      : Layer(count, jittered, physics, layer({width * (1.0 / count), 1}, 1.0 / count), start) {}

  /// The mean over the height of half of sum_k |C_k - exact_k|, means of the rows: the share of grains in wrong places.
  template <class Exact>
  double error(Exact const& exact) const {
    std::vector<Mixture> mean(std::size_t(rows), Mixture::Zero());
    auto const C = solver.material().to_host(concentrations<3>);
    for (std::size_t i = 0; i < C.size(); ++i) mean[std::size_t(heights[i] / dr)] += C[i] / width;
    double sum = 0;
    for (int row = 0; row < rows; ++row)
      sum += (mean[std::size_t(row)] - exact(row * dr, (row + 1) * dr)).cwiseAbs().sum() / 2;
    return sum / rows;
  }
  double off_range() const {
    double found = 0;
    for (auto const& C : solver.material().to_host(concentrations<3>))
      found = std::max({found, -C.minCoeff(), C.maxCoeff() - 1, std::abs(C.sum() - 1)});
    return found;
  }

 private:
  template <class Start>
  Layer(int count, double jittered, Physics const& physics, Bed<2> bed, Start const& start)
      : dr(1.0 / count),
        rows(count),
        heights([&] {
          std::vector<double> found;
          for (auto const& x : bed.material) found.push_back(x[1]);
          if (jittered > 0) jitter(bed.material, jittered * dr, 1);
          return found;
        }()),
        solver(
            solver_of<Formulated<Plane, Physics>>(bed, dr, physics, {}, {{.axis = 0, .low = 0, .high = width * dr}})) {
    std::size_t next = 0;
    solver.set(concentrations<3>, [&](auto const&) { return Mixture(start(heights[next++])); });
  }
};

Mixture inverted(double z) { return {z > 0.7 ? 1.0 : 0.0, z > 0.3 && z < 0.7 ? 1.0 : 0.0, z < 0.3 ? 1.0 : 0.0}; }

/// Speeds S_kl = v_k - v_l of v = (1, 0.5, 0).
SpeciesColumn<3> column(int cells) {
  SpeciesColumn<3>::Speeds S;
  S << 0, 0.5, 1, -0.5, 0, 0.5, -1, -0.5, 0;
  return {cells, S, inverted};
}

struct Way {
  double error = 0;      ///< largest over the times, spacings
  double reference = 0;  ///< largest difference of finite volumes from those with half as many cells, spacings
  double off_range = 0;
  double in_wrong_layer = 0;  ///< at the end, spacings
};
Way sort_layers(int rows, double jittered, int cells) {
  Layer<SpeciesSegregation<ConstantSpecies<3>>> layer(rows, jittered, {.closure = {.velocities = {1, 0.5, 0}}},
                                                      inverted);
  auto coarse = column(cells / 2), fine = column(cells);
  Way way;
  for (double const time : {0.4, 0.8, 1.2, 1.6, 2.4, 4.0}) {
    layer.solver.run(time), coarse.run(time), fine.run(time);
    way.error = std::max(way.error, rows * layer.error([&](double low, double high) { return fine.mean(low, high); }));
    double difference = 0;
    for (int row = 0; row < rows; ++row) {
      double const low = double(row) / rows, high = double(row + 1) / rows;
      difference += (coarse.mean(low, high) - fine.mean(low, high)).cwiseAbs().sum() / 2;
    }
    way.reference = std::max(way.reference, difference);
    way.off_range = std::max(way.off_range, layer.off_range());
  }
  way.in_wrong_layer = rows * layer.error([](double low, double high) { return inverted(1 - (low + high) / 2); });
  UNSCOPED_INFO(rows << " rows, displaced by " << jittered << ": error " << way.error
                     << " spacings, that of finite volumes " << way.reference << ", in wrong layers at the end "
                     << way.in_wrong_layer << ", off [0, 1] by " << way.off_range);
  return way;
}

/// A shear rate that rises with the height: the equilibria do not depend on it.
struct GivenShearRate {
  using reads = Fields<Position>;
  using writes = Fields<ShearRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[shear_rate] = 0.5 + i[position][1];
  }
};
template <class Closure>
struct Sheared {
  SpeciesSegregation<Closure> segregation;
  using evolves = Fields<Concentrations<3>>;
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(std::tuple(point_pass<Material>("given shear rate", GivenShearRate{})),
                          segregation.transport(resolution, Gravity{}));
  }
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
};

/// The flux of a kinetic stress with D in proportion to the shear rate alone, for which there is a closed form.
struct KineticStress : KineticStressClosure<3> {
  double D = 0.05;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    KineticStressClosure<3>::operator()(i, out);
    out[diffusivity] = D * i[shear_rate];
  }
};
KineticStressClosure<3> const kinetic{.diameters = {0.5, 1, 2}, .c = 0.1};
/// m.
double measure(Mixture const& C) { return C.cwiseQuotient(kinetic.diameters).sum(); }
/// Its equilibrium in a layer of height 1 with given means, for any g: D dC_k/dz = -c C_k (1/(d_k m) - 1). With dz = m
/// dy it is d ln C_k/dy = -(c/D)(1/d_k - m), so that C_k = b_k exp(-(c/D) y/d_k)/Z with the sum Z of all, and because
/// dZ/dy = -(c/D) m Z, z = -(D/c) ln Z where the sum of the b_k is 1.
class KineticEquilibrium {
 public:
  KineticEquilibrium(KineticStress const& flux, Mixture const& means) : flux_(flux), b_(means) {
    for (int k = 0; k < 500; ++k) {
      b_ = b_.cwiseProduct(means.cwiseQuotient(mean(0, 1)));
      b_ /= b_.sum();
    }
  }
  Mixture mean(double low, double high) const {
    double const from = at(low), dy = (at(high) - from) / parts;
    Mixture sum = Mixture::Zero();
    double thickness = 0;
    for (int k = 0; k < parts; ++k) {
      Mixture const C = mixture(from + (k + 0.5) * dy);
      sum += measure(C) * dy * C, thickness += measure(C) * dy;
    }
    return sum / thickness;
  }

 private:
  static constexpr int parts = 100;
  Mixture weights(double y) const {
    Mixture all;
    for (int k = 0; k < 3; ++k) all[k] = b_[k] * std::exp(-flux_.c / flux_.D * y / flux_.diameters[k]);
    return all;
  }
  Mixture mixture(double y) const {
    Mixture const all = weights(y);
    return all / all.sum();
  }
  /// y at a height, by bisection.
  double at(double z) const {
    double low = 0, high = flux_.diameters.maxCoeff();
    for (int k = 0; k < 60; ++k) {
      double const y = (low + high) / 2;
      (-flux_.D / flux_.c * std::log(weights(y).sum()) < z ? low : high) = y;
    }
    return (low + high) / 2;
  }

  KineticStress flux_;
  Mixture b_;
};
struct Settled {
  double error, from_start;
};
Settled settle_by_kinetic_stress(int rows) {
  KineticStress const flux{kinetic};
  Mixture const means(0.3, 0.3, 0.4);
  KineticEquilibrium const exact(flux, means);
  Layer<Sheared<KineticStress>> layer(rows, 0, {{.closure = flux}}, [&](double) { return means; });
  auto const off = [&] { return layer.error([&](double low, double high) { return exact.mean(low, high); }); };
  double const at_start = off();
  layer.solver.run(25);
  UNSCOPED_INFO(rows << " rows: error " << off() << ", at the start " << at_start << ", off [0, 1] by "
                     << layer.off_range());
  return {off(), at_start};
}

/// The mean error of a row's mixture, from even mixtures to the equilibrium of speeds S_kl (1/s over the shear rate).
template <class Closure>
double settle(int rows, Closure const& closure, double time, SpeciesEquilibrium<3>::Speeds const& speeds) {
  Mixture const even(0.3, 0.3, 0.4);
  Layer<Sheared<Closure>> layer(rows, 0, {{.closure = closure}}, [&](double) { return even; });
  layer.solver.run(time);
  auto const D = [&](Mixture const& C) { return closure.A * sq(mean_of_species(C, closure.diameters)); };
  SpeciesEquilibrium<3> const exact(40 * rows, speeds, D, even), coarser(20 * rows, speeds, D, even);
  double reference = 0;
  for (double z = 0; z < 0.95; z += 0.1)
    reference = std::max(reference, (exact.mean(z, z + 0.1) - coarser.mean(z, z + 0.1)).cwiseAbs().maxCoeff());
  CHECK(reference < 1e-6);
  double const error = layer.error([&](double low, double high) { return exact.mean(low, high); });
  double const mixed = layer.error([&](double, double) { return even; });
  UNSCOPED_INFO(rows << " rows: error " << error << ", that of the exact one " << reference << "; from the start "
                     << mixed << ", off [0, 1] by " << layer.off_range());
  CHECK(mixed > 0.15);
  return error;
}
/// A matrix S_kl of a function of k and l.
template <class Function>
Mat<3, double> matrix(Function const& of) {
  Mat<3, double> S;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) S(k, l) = of(k, l);
  return S;
}
double settle_by_ratio(int rows) {
  SizeRatioClosure<3> const closure{.diameters = {0.05, 0.1, 0.2}};
  auto const speeds = matrix([&](int k, int l) {
    double const a = closure.diameters[k], b = closure.diameters[l];
    return closure.S * std::min(a, b) * std::log(b / a);
  });
  return settle(rows, closure, 1000, [=](Mixture const&) { return speeds; });
}
double settle_by_kinetic_stress_and_size(int rows) {
  KineticStressClosure<3> const closure{.diameters = {0.5, 1, 2}, .c = 0.1, .A = 0.02};
  // From the velocity of a species, c (1/(d_k m) - 1) less the mean of all, which is 0.
  auto const speeds = [&](Mixture const& C) {
    Mixture const fast = closure.c * (closure.diameters.cwiseInverse() / measure(C) - Mixture::Ones());
    return matrix([&](int k, int l) { return fast[k] - fast[l]; });
  };
  return settle(rows, closure, 30, speeds);
}

}  // namespace

TEST_CASE("three layers in inverted order sort themselves as finite volumes say") {
  auto const coarse = sort_layers(40, 0, 1600);
  CHECK(coarse.error < 2);
  CHECK(coarse.reference < 0.5);
  CHECK(coarse.off_range < 1e-12);
  CHECK(coarse.in_wrong_layer < 1);
  auto const jittered = sort_layers(40, 0.1, 1600);
  CHECK(jittered.error < 3);
  CHECK(jittered.off_range < 1e-12);
}
TEST_CASE("three layers in inverted order sort themselves as finite volumes say, finer", "[.long]") {
  auto const fine = sort_layers(100, 0, 4000);
  CHECK(fine.error < 2);
  CHECK(fine.off_range < 1e-12);
}

TEST_CASE("three sizes whose speeds do not add up find their equilibrium") {
  auto const coarse = settle_by_ratio(18), fine = settle_by_ratio(36);
  INFO("errors " << coarse << " and " << fine);
  CHECK(fine < 1e-3);
  CHECK(fine < 0.3 * coarse);
}

TEST_CASE("three sizes that a kinetic stress sorts find their equilibrium") {
  auto const coarse = settle_by_kinetic_stress(10), fine = settle_by_kinetic_stress(20);
  CHECK(fine.from_start > 0.1);
  CHECK(fine.error < 1e-3);
  CHECK(fine.error < 0.35 * coarse.error);
}
TEST_CASE("three sizes that a kinetic stress sorts and larger grains mix faster find their equilibrium") {
  auto const coarse = settle_by_kinetic_stress_and_size(10), fine = settle_by_kinetic_stress_and_size(20);
  INFO("errors " << coarse << " and " << fine);
  CHECK(fine < 1e-3);
  CHECK(fine < 0.35 * coarse);
}

}  // namespace scree::test::species_layers_tests
