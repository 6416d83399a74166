// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "columns.hpp"
#include "models.hpp"
#include "points.hpp"
#include "results.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/profile.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/point_data_of.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/cast.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/solver/solver.hpp>
#include <scree/surface/detect.hpp>
#include <scree/terms/consistent_gradient.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// The rotating drum of Zhu, Peng & Wu (2024), section 6: granular flow by mu(I), and segregation driven by its shear.
namespace drum {

namespace detail {
template <class F>
auto gradient_pass(scree::Resolution const& resolution) {
  using Body = scree::Material;
  scree::ConsistentGradient<F> const gradient{resolution.smoothing_length};
  return std::tuple(scree::pair_pass_then<Body>(
      "drum::gradient", gradient, scree::over<Body>(scree::ConsistencyMatrixSum{}, scree::ConsistencyVectorSum<F>{})));
}
}  // namespace detail

template <class Sizes>
inline constexpr bool is_list = std::is_same_v<Sizes, ListOfSizes>;

/// The surface; for two sizes also the gradients that the parts of the concentration rate need, made exact for linear
/// fields there too.
template <class Sizes>
struct Diagnostics {
  auto passes(scree::Resolution const& resolution) const {
    if constexpr (is_list<Sizes>)
      return scree::surface_passes(resolution);
    else
      return std::tuple_cat(scree::surface_passes(resolution), detail::gradient_pass<scree::Concentration>(resolution),
                            detail::gradient_pass<scree::SegregationVelocity>(resolution));
  }
};

namespace detail {

/// The concentrations of a list of sizes. There are no parts of dC/dt.
template <class All>
void add_species(State& state, All const& all, app::SpeciesList const& list) {
  auto const mixtures = all(scree::fields::concentrations<ListOfSizes::species>);
  state.species.resize(std::size_t(list.count()));
  for (int k = 0; k < list.count(); ++k)
    for (auto const& C : mixtures) state.species[std::size_t(k)].push_back(double(C[k]));
  state.C = state.species[std::size_t(list.smallest())];
  for (auto* missing : {&state.V, &state.gradient_V_rate, &state.gradient_C_rate, &state.diffusion_rate})
    missing->assign(state.size(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace detail

/// The material of all ranks now; rates are brought up to date first.
template <class Sizes, class S>
State state_of(S& solver, Options const& o) {
  using namespace scree::fields;
  using Of = Columns<S::policy::dim, typename S::policy::real>;
  solver.update_rates();
  solver.update_diagnostics();
  auto const material = solver.whole();
  auto const order = material.order();
  auto const all = [&](auto field) { return order.of(material.here().to_host(field)); };
  auto const x = all(position), u = all(velocity);
  State state;
  state.time = solver.time();
  state.steps = solver.steps();
  state.x = Of::component(x, 0), state.y = Of::component(x, 1), state.z = Of::component(x, 2);
  state.u = Of::component(u, 0), state.v = Of::component(u, 1), state.w = Of::component(u, 2);
  state.shear_rate = Of::doubles(all(shear_rate));
  state.number_density = Of::doubles(all(number_density));
  for (double& phi : state.number_density) phi /= solver.resolution().lattice_sum;
  state.volume = Of::doubles(all(scree::fields::volume));
  state.D = Of::doubles(all(diffusivity));
  state.stress = Of::stresses(all(stress));
  if constexpr (is_list<Sizes>) {
    detail::add_species(state, all, o.species);
  } else {
    state.C = Of::doubles(all(concentration));
    state.V = Of::doubles(all(segregation_velocity));
    auto const& physics = solver.settings().physics;
    auto const grad_C = all(gradient<scree::Concentration>), grad_V = all(gradient<scree::SegregationVelocity>);
    Of::add_rates(state, grad_C, grad_V, all(concentration_rate), physics.transport.flux,
                  physics.mechanics.gravity.direction());
  }
  // A state that is not finite is reported with the results.
  if (std::ranges::all_of(state.C, [](double C) { return std::isfinite(C); })) {
    state.intensity = scree::segregation_intensity(solver).value;
    state.lacey = scree::lacey_index(solver).index;
  }
  return state;
}

/// 1 where particles are as dense as on the initial lattice.
struct RelativeDensity : scree::Scalar<"number density", "1"> {
  using reads = scree::Fields<scree::NumberDensity>;
  template <class I>
  static double of(I const& i, scree::Resolution const& resolution) {
    return double(i[scree::fields::number_density]) / resolution.lattice_sum;
  }
};
/// The fields in particles.vtkhdf.
template <class Sizes>
using FrameFields = std::conditional_t<
    is_list<Sizes>,
    scree::Merge<scree::Fields<scree::Velocity>, ListOfSizes::EachConcentration,
                 scree::Fields<scree::ShearRate, scree::Stress, RelativeDensity, scree::Diffusivity, scree::SurfaceSet,
                               scree::FreeSurfaceNormal, scree::WallNormal, scree::Identity>>,
    scree::Fields<scree::Velocity, scree::Concentration, scree::ShearRate, scree::Stress, RelativeDensity,
                  scree::SegregationVelocity, scree::Diffusivity, scree::SurfaceSet, scree::FreeSurfaceNormal,
                  scree::WallNormal, scree::Identity>>;

/// Material and walls now, with rates brought up to date.
template <class Sizes, class S>
scree::PointData frame_of(S& solver, Options const& o) {
  solver.update_rates();
  auto frame = scree::point_data_of(solver, FrameFields<Sizes>{}, scree::Bodies<scree::Material, scree::Wall>{});
  if constexpr (is_list<Sizes>)  // absent species
    for (int k = o.species.count() + 1; k <= ListOfSizes::species; ++k)
      std::erase_if(frame.arrays,
                    [&](auto const& array) { return array.name == "concentration_" + std::to_string(k); });
  return frame;
}

template <int Dim, class Real, class Sizes>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics =
      scree::SegregatingGranular<scree::Granular<Models<typename Sizes::Grains>>, typename Sizes::Segregation>;
  // The paper's predictor-corrector makes elastic waves grow, by (omega dt)^4/8 per step; this one does not.
  using integrator = scree::SymplecticEuler;
  using motion = scree::Rotation;
  using diagnostics = Diagnostics<Sizes>;
};

/// Runs a case, or one rank of it.
template <class P, class Sizes>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using Real = typename P::real;
  constexpr int Dim = P::dim;
  Options const& o = run.options;
  auto const particles = points<Dim>(o);
  auto const wall = motion(o);

  scree::Solver<P> solver(space,
                          {.spacing = o.numerics.spacing,
                           .smoothing = o.numerics.smoothing,
                           .physics = {mechanics(o, Sizes::grains(o)), Sizes::segregation(o), segregation_period(o)},
                           .motion = wall,
                           .periods = periods<Dim>(o),
                           .sort_period = 20'000,  // several times per turn or more, because grains mix
                           .ranks = ranks},
                          scree::cast<Real>(particles.material), scree::cast<Real>(particles.wall));

  // The bed turns with the drum from the beginning, under its own weight, well inside yield.
  scree::Geostatic const weight{
      .surface_height = initial_level(o), .density = o.material.density, .gravity = o.geometry.gravity, .K0 = 1};
  auto const& x = particles.material;
  solver.set(stress, x, [&](auto const& at) { return scree::packed<Dim>(weight(at)).template cast<Real>().eval(); });
  solver.set(velocity, x, [&](auto const& at) { return wall.velocity(at, 0).template cast<Real>().eval(); });
  if constexpr (is_list<Sizes>) {
    auto const mixed = o.species.mixed().template cast<Real>().eval();
    solver.set(concentrations<Sizes::species>, x, [&](auto const&) { return mixed; });
  } else {
    solver.set(concentration, x, [&](auto const&) { return Real(o.segregation.C0); });
  }
  solver.set(scree::fields::volume, particles.volumes, [](double v) { return Real(v); });

  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  Start start;
  std::optional<Results> results;
  checkpoints.keep(
      "recorder", [&] { return results->memory(); }, [&](auto const& kept) { start.memory = kept; });
  checkpoints.restore(solver, o.time.duration, {}, "");  // Results reads its tables and frames
  start.time = solver.time();
  results.emplace(run, start, [&] { run.begin(solver); });
  scree::Progress progress({.end = o.time.duration, .name = "t/s", .quiet = run.quiet});
  using S = scree::Solver<P>;
  scree::Profiler const profiler(solver);
  run_with(solver, o.time.duration,
           {scree::every<S>(o.output.history_interval, [&](S& now) { results->add_history(state_of<Sizes>(now, o)); }),
            scree::every<S>(o.output.frame_interval, [&](S& now) { results->add_frame(frame_of<Sizes>(now, o)); })},
           progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::print_profile(run, profiler, solver);
  results->finish(app::figures_of(solver));
  return checkpoints.exit_code();
}

template <int Dim, class Real, class Sizes>
int simulate(app::Run<Options> const& run, Kokkos::DefaultExecutionSpace const& space) {
  using P = app::AsCompiled<Formulation<Dim, Real, Sizes>>;
  return app::run_ranks<P>(run, space, run.options.numerics.ranks, simulate_rank<P, Sizes>);
}

}  // namespace drum
