// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/oscillating_shear.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/kinetic_stress_closure.hpp>
#include <scree/segregation/size_density_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <random>

namespace scree::test::species_tests {
using namespace fields;
namespace {

template <int N>
using Physics = SpeciesSegregation<ConstantSpecies<N>>;
template <int N>
using Mixture = Vec<N, double>;

template <int Dim>
Vec<Dim, double> small_box() {
  Vec<Dim, double> size = Vec<Dim, double>::Constant(0.6);
  size[Dim - 1] = 1;
  return size;
}

/// Mixtures of N species, many of which lack one or more of them.
template <int N>
std::vector<Mixture<N>> random_mixtures(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Mixture<N>> mixtures;
  while (mixtures.size() < count) {
    Mixture<N> C;
    for (int k = 0; k < N; ++k) C[k] = std::max(0.0, std::ldexp(double(random() >> 11), -53) - 0.3);
    if (C.sum() > 0) mixtures.push_back(C / C.sum());
  }
  return mixtures;
}
template <int N, class S>
void set_mixtures(S& solver, std::vector<Mixture<N>> const& values) {
  using real = typename S::policy::real;
  std::size_t next = 0;
  solver.set(concentrations<N>, [&](auto const&) { return values[next++].template cast<real>().eval(); });
}
template <int N, class S, class Function>
void set_mixture(S& solver, Function const& function) {
  using real = typename S::policy::real;
  solver.set(concentrations<N>,
             [&](auto const& x) { return function(double(x[x.size() - 1])).template cast<real>().eval(); });
}
template <int N, class S>
std::vector<Mixture<N>> mixtures_of(S const& solver) {
  std::vector<Mixture<N>> found;
  for (auto const& C : solver.material().to_host(concentrations<N>)) found.push_back(C.template cast<double>());
  return found;
}
template <int N, class S>
std::vector<Mixture<N>> rates_of(S& solver) {
  solver.update_rates();
  std::vector<Mixture<N>> found;
  for (auto const& rate : solver.material().to_host(concentration_rates<N>))
    found.push_back(rate.template cast<double>());
  return found;
}
template <int N>
double largest(std::vector<Mixture<N>> const& all) {
  double found = 0;
  for (auto const& each : all) found = std::max(found, each.cwiseAbs().maxCoeff());
  return found;
}
template <int N>
Mixture<N> total(std::vector<Mixture<N>> const& all) {
  Mixture<N> sum = Mixture<N>::Zero();
  for (auto const& each : all) sum += each;
  return sum;
}
/// The largest distance of the sums from 1.
template <int N>
double off_one(std::vector<Mixture<N>> const& all) {
  double found = 0;
  for (auto const& each : all) found = std::max(found, std::abs(each.sum() - 1));
  return found;
}
template <int N>
double out_of_range(std::vector<Mixture<N>> const& all) {
  double found = 0;
  for (auto const& each : all) found = std::max({found, -each.minCoeff(), each.maxCoeff() - 1});
  return found;
}

/// C_k = a_k exp(-v_k z/D)/sum_l a_l exp(-v_l z/D) with equal a_k.
template <int N>
Mixture<N> equilibrium(Mixture<N> const& v, double D, double z) {
  Mixture<N> C;
  for (int k = 0; k < N; ++k) C[k] = std::exp(-v[k] * z / D);
  return C / C.sum();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("N species: nothing is created or destroyed, and the sum of all stays", "", Policies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  auto solver =
      solver_of<Formulated<P, Physics<4>>>(bed, 0.1, {.closure = {.velocities = {2, 0.5, -1, 0}, .diffusivity = 0.03}});
  set_mixtures<4>(solver, random_mixtures<4>(bed.material.size(), 5));
  auto const rates = rates_of<4>(solver);
  double magnitude = 0;
  for (auto const& rate : rates) magnitude += rate.cwiseAbs().sum();
  CHECK(magnitude > 1);
  CHECK(total<4>(rates).cwiseAbs().maxCoeff() < ulps<P>(16) * magnitude);
  for (auto const& rate : rates) CHECK(std::abs(rate.sum()) < ulps<P>(64) * largest<4>(rates));
}

// Species 0 and 1 have the same ratio in both particles, to the last bit: neither has more of them, and diffusion of
// one through the other rests.
TEST_CASE("a pair of particles with the same ratio of two species keeps what one gives and the other takes") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto solver =
      solver_of<Formulated<P, Physics<3>>>({{{0, 0}, {0.03, 0.1}}, {}}, 0.1, {.closure = {.velocities = {1, 0.4, 0}}});
  bool const upside_down = GENERATE(false, true);
  set_mixture<3>(solver, [&](double z) {
    return (z > 0.05) == upside_down ? Mixture<3>(0.5, 0.25, 0.25) : Mixture<3>(0.25, 0.125, 0.625);
  });
  auto const rates = rates_of<3>(solver);
  INFO(rates[0].transpose() << " and " << rates[1].transpose());
  CHECK(rates[0].norm() > 0.1);
  CHECK((rates[0] + rates[1]).norm() < 1e-15 * rates[0].norm());
}

/// The same closure without its factors.
template <class Closure>
struct WithoutFactors {
  Closure closure;
  static constexpr int species = Closure::species;
  using reads = reads_of<Closure>;
  using writes = writes_of<Closure>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    closure(i, out);
  }
};
template <class P, class Closure>
void check_factors(Closure const& closure, std::string const& name) {
  constexpr int N = Closure::species, dim = P::dim;
  OscillatingShear const shear{.amplitude = 3, .period = 2};
  auto bed = open_bed<dim>(small_box<dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  auto const rates = [&](auto const& with) {
    using Transport = SpeciesSegregation<std::remove_cvref_t<decltype(with)>>;
    auto solver = solver_of<Formulated<P, Transport, OscillatingShear>>(bed, 0.1, Transport{.closure = with}, shear);
    set_mixtures<N>(solver, random_mixtures<N>(bed.material.size(), 5));
    auto found = rates_of<N>(solver);
    found.push_back(Mixture<N>::Constant(solver.step(1)));  // the limits of the step, too
    return found;
  };
  auto const from_factors = rates(closure), stored = rates(WithoutFactors<Closure>{closure});
  double different = 0;
  for (std::size_t i = 0; i < stored.size(); ++i)
    different = std::max(different, (from_factors[i] - stored[i]).cwiseAbs().maxCoeff());
  INFO(name << ": rates of " << largest<N>(stored) << " differ by " << different);
  CHECK(largest<N>(stored) > 0);
  CHECK(different < ulps<P>(64) * largest<N>(stored));
}
/// A closure whose velocities are not those of its base.
struct Halved : SizeRatioClosure<4> {
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    SizeRatioClosure<4>::operator()(i, out);
    out[segregation_velocities<4>] = out[segregation_velocities<4>] / 2;
  }
};
TEMPLATE_LIST_TEST_CASE("factors of a closure give the exchange that its velocities give", "", Policies) {
  using P = TestType;
  STATIC_CHECK(FactoredClosure<SizeRatioClosure<4>>);
  STATIC_CHECK(!FactoredClosure<Halved>);
  Mixture<4> const sizes(0.02, 0.01, 0.03, 0.025), densities(1000, 2000, 1500, 1000);  // in no order
  check_factors<P>(SizeRatioClosure<4>{.diameters = sizes}, "sizes");
  check_factors<P>(Halved{{.diameters = sizes}}, "a derived closure");
  check_factors<P>(SizeDensityClosure<4>{.diameters = sizes, .densities = densities, .S_density = 0.3}, "densities");
  check_factors<P>(KineticStressClosure<4>{.diameters = sizes, .c = 0.02}, "kinetic stress");
  check_factors<P>(ConstantSpecies<4>{.velocities = {0.1, 0.3, -0.2, 0}, .diffusivity = 0.01}, "constants");
}

// Two species of four differ by their speed alone from the others, so that they share what one of two has.
TEMPLATE_LIST_TEST_CASE("two species are those of the scheme for two sizes", "", DoublePolicies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  double const V = 2, D = 0.03;
  auto const mixtures = random_mixtures<2>(bed.material.size(), 7);
  auto of_two = solver_of<Formulated<P, ConservativeSegregation<ConstantClosure>>>(
      bed, 0.1, {{.velocity = V, .diffusivity = D}, SegregationFlux::symmetric()});
  auto of_species = solver_of<Formulated<P, Physics<2>>>(
      bed, 0.1, {.closure = {.velocities = {V / 3, -2 * V / 3}, .diffusivity = D}});
  std::size_t next = 0;
  set_field(of_two, concentration, [&](auto const&) { return mixtures[next++][0]; });
  set_mixtures<2>(of_species, mixtures);
  auto const compare = [&](double most) {
    auto const C = concentrations_of(of_two);
    auto const all = mixtures_of<2>(of_species);
    double different = 0;
    for (std::size_t i = 0; i < C.size(); ++i) different = std::max(different, std::abs(all[i][0] - C[i]));
    INFO("at " << of_species.time() << " s they differ by " << different);
    CHECK(of_species.time() == of_two.time());
    CHECK(different < most);
  };
  of_two.step(1), of_species.step(1);
  compare(1e-14);
  for (int k = 0; k < 100; ++k) of_two.step(1), of_species.step(1);
  compare(1e-12);
}

TEMPLATE_LIST_TEST_CASE("of three species two are alike: their sum is one of two species", "", DoublePolicies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  double const V = 0.2, D = 0.03;  // smooth: the limits of a pair of species act on each of them
  auto of_two = solver_of<Formulated<P, ConservativeSegregation<ConstantClosure>>>(
      bed, 0.1, {{.velocity = V, .diffusivity = D}, SegregationFlux::symmetric()});
  auto of_three =
      solver_of<Formulated<P, Physics<3>>>(bed, 0.1, {.closure = {.velocities = {V, 0, 0}, .diffusivity = D}});
  set_field(of_two, concentration, [](auto const& x) { return 0.4 + 0.2 * std::sin(3 * x[P::dim - 1]); });
  set_mixture<3>(of_three, [](double z) {
    double const C = 0.4 + 0.2 * std::sin(3 * z);
    return Mixture<3>(C, (1 - C) * 0.3, (1 - C) * 0.7);
  });
  for (int k = 0; k < 100; ++k) of_two.step(1), of_three.step(1);
  auto const C = concentrations_of(of_two);
  auto const all = mixtures_of<3>(of_three);
  double first = 0, share = 0;
  for (std::size_t i = 0; i < C.size(); ++i) {
    first = std::max(first, std::abs(all[i][0] - C[i]));
    share = std::max(share, std::abs(all[i][1] / (all[i][1] + all[i][2]) - 0.3));
  }
  INFO("after " << of_two.time() << " s: " << first << ", share of the second " << share);
  CHECK(first < 1e-13);
  CHECK(share < 1e-13);
}

TEMPLATE_LIST_TEST_CASE("pairs of a mixture in equilibrium exchange nothing, beside walls and in corners too", "",
                        DoublePolicies) {
  using P = TestType;
  Mixture<4> const v(0.1, 0.06, 0, -0.04);
  double const D = 0.03;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  for (double const disorder : {0.0, 0.02}) {
    jitter(bed.material, disorder, 8);
    auto solver = solver_of<Formulated<P, Physics<4>>>(bed, 0.1, {.closure = {.velocities = v, .diffusivity = D}});
    double const scale = D / sq(0.1) * 0.1;
    set_mixture<4>(solver, [&](double z) { return equilibrium<4>(v, D, z - 0.5); });
    CHECK(largest<4>(rates_of<4>(solver)) < ulps<P>(2000) * scale);
    set_mixture<4>(solver, [&](double z) { return equilibrium<4>(v, D, 0.5 - z); });  // upside down
    CHECK(largest<4>(rates_of<4>(solver)) > 0.3 * scale);
  }
}

TEST_CASE("four species that are mixed come to their equilibrium in a layer") {
  using P = Policy<2, double, Kokkos::DefaultExecutionSpace>;
  Mixture<4> const v(0.1, 0.06, 0, -0.04);
  double const D = 0.03, dr = 0.05;
  Bed<2> const bed{lattice<2>(dr), {}};
  auto solver = solver_of<Formulated<P, Physics<4>>>(bed, dr, {.closure = {.velocities = v, .diffusivity = D}});
  set_mixture<4>(solver, [](double) { return Mixture<4>::Constant(0.25); });
  solver.run(40);  // the slowest mode decays by exp(-pi^2 D t/H^2)
  // The amounts a_k of the equilibrium with the means 1/4, by iteration.
  auto const x = solver.material().to_host(position);
  Mixture<4> a = Mixture<4>::Constant(1);
  auto const exact = [&](double z) {
    Mixture<4> const C = a.cwiseProduct(equilibrium<4>(v, D, z));
    return Mixture<4>(C / C.sum());
  };
  for (int k = 0; k < 200; ++k) {
    Mixture<4> mean = Mixture<4>::Zero();
    for (auto const& at : x) mean += exact(at[1]) / double(x.size());
    a = a.cwiseQuotient(mean), a /= a.sum();
  }
  auto const found = mixtures_of<4>(solver);
  double off = 0;
  for (std::size_t i = 0; i < x.size(); ++i) off = std::max(off, (found[i] - exact(x[i][1])).cwiseAbs().maxCoeff());
  INFO("off by " << off);
  CHECK(off < 1e-6);
  CHECK(exact(0)[0] - exact(1)[0] > 0.4);
}

TEMPLATE_LIST_TEST_CASE("N species stay within [0, 1], without diffusion and in disorder too", "", DoublePolicies) {
  using P = TestType;
  double const dr = P::dim == 2 ? 0.05 : 0.1;
  Vec<P::dim, double> size = Vec<P::dim, double>::Constant(4 * dr);
  size[P::dim - 1] = 1;
  auto bed = open_bed<P::dim>(size, dr);
  for (double const D : {0.0, dr / 20}) {
    for (double const disorder : {0.0, 0.1}) {
      jitter(bed.material, disorder * dr, 4);
      auto solver = solver_of<Formulated<P, Physics<4>>>(
          bed, dr, {.closure = {.velocities = {1, 0.6, 0.3, 0}, .diffusivity = D}});
      set_mixtures<4>(solver, random_mixtures<4>(bed.material.size(), 9));
      auto const before = total<4>(mixtures_of<4>(solver));
      double worst = 0, sum = 0;
      for (int k = 0; k < (P::dim == 2 ? 600 : 200); ++k) {
        solver.step(1);
        auto const C = mixtures_of<4>(solver);
        worst = std::max(worst, out_of_range<4>(C)), sum = std::max(sum, off_one<4>(C));
      }
      auto const C = mixtures_of<4>(solver);
      INFO("D " << D << ", disorder " << disorder << ", after " << solver.time() << " s: out of range by " << worst
                << ", sums off by " << sum << ", means by "
                << (total<4>(C) - before).cwiseAbs().maxCoeff() / double(C.size()));
      CHECK(worst < 1e-12);
      CHECK(sum < 1e-13);
      CHECK((total<4>(C) - before).cwiseAbs().maxCoeff() < 1e-14 * double(C.size()));
    }
  }
}

TEST_CASE("three layers in inverted order become layers in order without diffusion") {
  using P = Policy<2, double, Kokkos::DefaultExecutionSpace>;
  double const dr = 1.0 / 40;
  Bed<2> const bed{fill_lattice(Box<2>{{0, 0}, {6 * dr, 1}}, dr), {}};
  auto solver = solver_of<Formulated<P, Physics<3>>>(bed, dr, {.closure = {.velocities = {1, 0.5, 0}}}, {},
                                                     {{.axis = 0, .low = 0, .high = 6 * dr}});
  auto const layers = [](double z) { return Mixture<3>(z > 0.7 ? 1 : 0, z > 0.3 && z < 0.7 ? 1 : 0, z < 0.3 ? 1 : 0); };
  set_mixture<3>(solver, layers);
  solver.run(12);
  auto const found = mixtures_of<3>(solver);
  auto const x = solver.material().to_host(position);
  double wrong = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const z = x[i][1];
    Mixture<3> const exact(z < 0.3 ? 1 : 0, z > 0.3 && z < 0.7 ? 1 : 0, z > 0.7 ? 1 : 0);
    wrong += (found[i] - exact).cwiseAbs().sum() / 2 / double(x.size());
  }
  INFO("share in the wrong layer " << wrong);
  CHECK(wrong < 0.02);
  CHECK(out_of_range<3>(found) < 1e-12);
}

TEST_CASE("mixtures and closures that make no sense are refused") {
  using Catch::Matchers::ContainsSubstring;
  using P = Policy<2, double, Kokkos::DefaultExecutionSpace>;
  Bed<2> const bed{lattice<2>(0.1), {}};
  auto solver = solver_of<Formulated<P, Physics<3>>>(bed, 0.1, {.closure = {.velocities = {1, 0, 0}}});
  set_mixture<3>(solver, [](double) { return Mixture<3>(0.5, 0.5, 0.5); });
  CHECK_THROWS_WITH(solver.step(1), ContainsSubstring("distance of the concentrations from a mixture") &&
                                        ContainsSubstring("their sum is 1"));
  auto const sizes = [&](Vec<3, double> const& d) {
    SpeciesSegregation<SizeRatioClosure<3>>{.closure = {.diameters = d}}.check();
  };
  CHECK_NOTHROW(sizes({1e-3, 2e-3, 3e-3}));
  CHECK_THROWS_WITH(sizes({1e-3, 0, 3e-3}), ContainsSubstring("diameters[1] (m)"));
  CHECK_THROWS_WITH((ConstantSpecies<2>{.diffusivity = -1}.check()), ContainsSubstring("diffusivity"));
}

}  // namespace scree::test::species_tests
