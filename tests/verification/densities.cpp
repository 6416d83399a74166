// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "inclined.hpp"

#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Mixtures of species of different densities, at rest and in a flow down a slope.
namespace scree::test::inclined::densities_tests {
using namespace fields;
namespace {

using Mixture = Vec<2, double>;

struct AtRest : GranularModels {
  using law = MixtureDensity<MuOfI<>, 2>;
};
/// The mean of -sigma_zz of each row over the second half of a run less the exact one, over that at the floor: the
/// largest, and that of means over three rows, below the uppermost two rows.
struct Worst {
  double of_rows = 0, of_means = 0, speed = 0;
};
Worst at_rest(double below, double above, bool layers = false) {
  using P = GranularCase<2, Granular<AtRest>>;
  int const rows = 20;
  double const H = 0.1, dr = H / rows, width = 10 * dr;
  Mixture const densities(below, above);
  auto const C_at = [&](double z) {
    double const C = layers ? (z < H / 2 ? 1 : 0) : 1 - z / H;
    return Mixture(C, 1 - C);
  };
  auto const pressure = [&](double z) {
    if (layers) return g * (above * (H - std::max(z, H / 2)) + below * std::max(0.0, H / 2 - z));
    return g * (H - z) * (below + (above - below) * (H + z) / (2 * H));
  };
  Granular<AtRest> physics{.law = {beads(10, 1e-3), densities}, .viscosity_speed = 5};
  Solver<P> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, width}}},
                   fill_lattice(Box<2>{{0, 0}, {width, H}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {width, 0}}, dr));
  solver.set(concentrations<2>, [&](auto const& x) { return C_at(x[1]); });
  solver.set(stress, [&](auto const& x) {
    double const p = pressure(x[1]);
    return Vec<4, double>(-p / 2, -p, -p / 2, 0);
  });
  std::vector<double> off(rows), number(rows);
  solver.run(0.3);
  Worst worst;
  solver.run(0.6, {every<Solver<P>>(1e-3, [&](Solver<P>& s) {
               auto const x = s.material().to_host(position), u = s.material().to_host(velocity);
               auto const sigma = s.material().to_host(stress);
               auto const C = s.material().to_host(concentrations<2>);
               for (std::size_t i = 0; i < x.size(); ++i) {
                 auto const row = std::size_t(std::clamp(int(x[i][1] / dr), 0, rows - 1));
                 off[row] += (-sigma[i][1] - pressure(x[i][1])) / pressure(0), number[row] += 1;
                 worst.speed = std::max(worst.speed, u[i].norm());
               }
             })});
  for (std::size_t row = 0; row < off.size(); ++row) off[row] /= number[row];
  for (std::size_t row = 0; row + 2 < off.size(); ++row) {
    double const before = off[row == 0 ? 0 : row - 1];
    worst.of_rows = std::max(worst.of_rows, std::abs(off[row]));
    worst.of_means = std::max(worst.of_means, std::abs(before / 4 + off[row] / 2 + off[row + 1] / 4));
  }
  show_packing(solver);
  return worst;
}

/// Speeds and a diffusivity in proportion to the shear rate, which have the same equilibrium for all of them.
struct InProportion {
  static constexpr int species = 2;
  double v = 0, A = 0;  // m, m^2
  using reads = Fields<ShearRate>;
  using writes = Fields<SegregationVelocities<2>, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    double const rate = i[shear_rate];
    out[segregation_velocities<2>][0] = v * rate;
    out[diffusivity] = A * rate;
  }
};
struct InFlow : GranularModels {
  using law = VolumeMemory<MixtureDensity<MuOfI<>, 2>>;
  using volume_control = VolumeConsistency;
};
using Sorting = Combined<Granular<InFlow>, SpeciesSegregation<InProportion>>;
using Chute = Solver<GranularCase<2, Sorting, double, SymplecticEuler>>;

Mixture const densities(2000, 1000);  // heavy grains are the first species
/// C of the heavy grains in equilibrium over a layer of the depth `top`, half of each: 1/(1 + exp(c (z - top/2))).
struct Equilibrium {
  double c, top;
  double operator()(double z) const { return 1 / (1 + std::exp(c * (z - top / 2))); }
};
/// The exact flow of a layer whose mixture depends on the height. The friction, and with it the inertial number, is
/// that of the slope; the shear rate is I sqrt(p/rho_s)/d with the grains of the mixture. By midpoints of cells.
class Flow {
 public:
  template <class Concentration>
  Flow(Bagnold const& of_one, Concentration const& C, double top) : dz_(top / cells), p_(cells + 1), u_(cells + 1) {
    auto const rho = [&](int cell) {
      return mean_of_species(Mixture(C((cell + 0.5) * dz_), 1 - C((cell + 0.5) * dz_)), densities);
    };
    for (int k = cells - 1; k >= 0; --k)
      p_[std::size_t(k)] = p_[std::size_t(k) + 1] + g * std::cos(of_one.angle) * rho(k) * dz_;
    for (int k = 0; k < cells; ++k) {
      double const rho_s = of_one.law.grain_density * rho(k) / of_one.law.density();
      double const p = (p_[std::size_t(k)] + p_[std::size_t(k) + 1]) / 2;
      u_[std::size_t(k) + 1] =
          u_[std::size_t(k)] + of_one.inertial_number() * std::sqrt(p / rho_s) / of_one.law.grains.diameter * dz_;
    }
  }
  double pressure(double z) const { return at(p_, z); }
  double velocity(double z) const { return at(u_, z); }

 private:
  static constexpr int cells = 2000;
  double at(std::vector<double> const& values, double z) const {
    double const n = std::clamp(z / dz_, 0.0, cells - 1e-9);
    auto const k = std::size_t(n);
    return values[k] + (n - double(k)) * (values[k + 1] - values[k]);
  }
  double dz_;
  std::vector<double> p_, u_;
};
template <class Start>
Chute chute(Slope const& slope, InProportion const& closure, Start const& C) {
  Bagnold const of_one = exact(slope);
  double const dr = depth / slope.rows, length = 10 * dr;
  Sorting physics;
  physics.mechanics.law = {{of_one.law, densities}};
  physics.mechanics.gravity = {g, of_one.angle};
  physics.mechanics.viscosity_speed = slope.viscosity_speed;
  physics.mechanics.cfl = 0.6;
  physics.transport.closure = closure;
  Chute solver({.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
               fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  Flow const flow{of_one, C, depth};
  solver.set(stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return Vec<4, double>(-p, -p, -p, std::tan(of_one.angle) * p);
  });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(flow.velocity(x[1]), 0); });
  solver.set(concentrations<2>, [&](auto const& x) { return Mixture(C(x[1]), 1 - C(x[1])); });
  return solver;
}
/// Heavy grains sink at `v` grain diameters per unit of shear.
InProportion closure_of(double v, double faster) { return {.v = v * faster * grain, .A = 0.0307 * faster * sq(grain)}; }
Equilibrium equilibrium_of(Slope const& slope, double v, double top) {
  return {std::cos(exact(slope).angle) * v / 0.0307 / grain, top};
}

struct Found {
  double error = 0;     ///< largest of the mean of C of a row over the last part of the run
  double velocity = 0;  ///< largest of a row in the middle of the layer, over the exact one
  double lost = 0;      ///< of the mean concentration
  double sorted = 0;    ///< C of the heavy grains in the lowest quarter less that in the highest, at the end
};
template <class Start>
Found after(Slope const& slope, double sinking, double faster, double time, Start const& start) {
  auto solver = chute(slope, closure_of(sinking, faster), start);
  auto const rows = std::size_t(slope.rows);
  std::vector<double> off(rows), number(rows), u(rows), exact_u(rows);
  Found found;
  for (int k = 0; k <= 50; ++k) {
    solver.run((0.9 + 0.002 * k) * time);
    auto const x = solver.material().to_host(position), v = solver.material().to_host(velocity);
    auto const C = solver.material().to_host(concentrations<2>);
    double height = 0, mean = 0;
    Mixture ends(0, 0), in_ends(0, 0);  // of the lowest and the highest quarter
    for (std::size_t i = 0; i < x.size(); ++i) {
      height += 2 * x[i][1] / double(x.size()), mean += C[i][0] / double(x.size());
      if (std::abs(x[i][1] / depth - 0.5) > 0.25)
        ends[x[i][1] > depth / 2] += C[i][0], in_ends[x[i][1] > depth / 2] += 1;
    }
    found.sorted = ends[0] / in_ends[0] - ends[1] / in_ends[1];
    Equilibrium const expected = equilibrium_of(slope, sinking, height);
    Flow const flow{exact(slope), expected, height};
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const row = std::size_t(std::clamp(int(x[i][1] / depth * slope.rows), 0, slope.rows - 1));
      off[row] += C[i][0] - expected(x[i][1]), number[row] += 1;
      if (x[i][1] > 0.2 * depth && x[i][1] < 0.8 * depth) u[row] += v[i][0], exact_u[row] += flow.velocity(x[i][1]);
    }
    found.lost = std::abs(mean - 0.5);
  }
  for (std::size_t row = 0; row < rows; ++row) {
    found.error = std::max(found.error, std::abs(off[row] / std::max(1.0, number[row])));
    if (exact_u[row] > 0) found.velocity = std::max(found.velocity, std::abs(u[row] / exact_u[row] - 1));
  }
  UNSCOPED_INFO(slope.angle << " degrees, " << slope.rows << " rows, " << faster << " times as fast, " << time
                            << " s: error " << found.error << ", velocity off by " << found.velocity << ", lost "
                            << found.lost << ", sorted " << found.sorted);
  show_packing(solver);
  return found;
}

}  // namespace

TEST_CASE("columns whose density changes with the height rest under their weight, heavy grains below or above") {
  auto const of_one = at_rest(1500, 1500);
  for (bool const layers : {false, true})
    for (auto const [below, above] : {std::array{2000.0, 1000.0}, std::array{1000.0, 2000.0}}) {
      auto const worst = at_rest(below, above, layers);
      CAPTURE(layers, below, above, worst.of_means, worst.of_rows, worst.speed, of_one.of_means, of_one.speed);
      CHECK(worst.of_means < 0.01);
      CHECK(worst.of_rows < 0.025);
      CHECK(worst.speed < 2 * of_one.speed);  // waves from the start
    }
}

TEST_CASE("heavy grains above light ones change places in a flow down a slope, down to their equilibrium") {
  Slope const slope{.angle = 24};
  auto const found = after(slope, 0.11, 30, 0.25, [](double z) { return z > depth / 2 ? 1.0 : 0.0; });
  CHECK(found.error < 0.03);
  CHECK(found.sorted > 0.98);
  CHECK(found.lost < 1e-12);
}

TEST_CASE("a flow of heavy grains below light ones has the velocity of its densities") {
  Slope const slope{.angle = 24};
  auto const found = after(slope, 0.03, 10, 0.1, equilibrium_of(slope, 0.03, depth));
  CHECK(found.error < 0.005);
  CHECK(found.velocity < 0.02);
}

}  // namespace scree::test::inclined::densities_tests
