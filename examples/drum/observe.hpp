// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "recorder.hpp"

#include <scree/io/point_data_of.hpp>
#include <scree/scree.hpp>
#include <scree/surface/detect.hpp>
#include <scree/terms/consistent_gradient.hpp>

// From a solver to what the recorder understands.
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

/// The surface, and the gradients that the parts of the concentration rate need, made exact for linear fields there
/// too.
struct Diagnostics {
  auto passes(scree::Resolution const& resolution) const {
    return std::tuple_cat(scree::surface_passes(resolution), detail::gradient_pass<scree::Concentration>(resolution),
                          detail::gradient_pass<scree::SegregationVelocity>(resolution));
  }
};

namespace detail {

/// One component of vectors; axis 0 is x, 1 y (empty in 2D), 2 z.
template <class Vectors>
std::vector<double> component(Vectors const& vectors, int axis) {
  constexpr int dim = Vectors::value_type::RowsAtCompileTime;
  std::vector<double> values;
  if (dim == 2 && axis == 1) return values;
  for (auto const& v : vectors) values.push_back(double(v[axis == 2 ? dim - 1 : axis]));
  return values;
}
template <class Values>
std::vector<double> doubles(Values const& values) {
  return {values.begin(), values.end()};
}
/// xx, yy, zz, xy, yz, xz of each particle.
template <class S>
std::vector<double> stresses(S const& material) {
  std::vector<double> all;
  for (auto const& sigma : material.to_host(scree::stress)) {
    auto const entries = scree::in_space<S::policy::dim, scree::Stress>(sigma);
    all.insert(all.end(), entries.begin(), entries.end());
  }
  return all;
}

/// The parts of dC/dt of figures 28 and 29: -F ghat . grad V, -V F' ghat . grad C and what remains, diffusion with the
/// sources of the boundary.
template <class S>
void add_rates(State& state, S const& material, scree::SegregationFlux const& flux,
               scree::GravityDirection const& down) {
  auto const grad_C = material.to_host(scree::gradient<scree::Concentration>);
  auto const grad_V = material.to_host(scree::gradient<scree::SegregationVelocity>);
  auto const rate = material.to_host(scree::concentration_rate);
  for (std::size_t i = 0; i < state.size(); ++i) {
    double const by_V = -flux.value(state.C[i]) * double(down.component(grad_V[i]));
    double const by_C = -state.V[i] * flux.slope(state.C[i]) * double(down.component(grad_C[i]));
    state.gradient_V_rate.push_back(by_V);
    state.gradient_C_rate.push_back(by_C);
    state.diffusion_rate.push_back(double(rate[i]) - by_V - by_C);
  }
}

}  // namespace detail

/// The material now; rates are brought up to date first.
template <class S>
State state_of(S& solver) {
  using namespace detail;
  solver.update_rates();
  solver.update_diagnostics();
  auto const& m = solver.material();
  auto const x = m.to_host(scree::position), u = m.to_host(scree::velocity);
  State state;
  state.time = solver.time();
  state.steps = solver.steps();
  state.x = component(x, 0), state.y = component(x, 1), state.z = component(x, 2);
  state.u = component(u, 0), state.v = component(u, 1), state.w = component(u, 2);
  state.C = doubles(m.to_host(scree::concentration));
  state.shear_rate = doubles(m.to_host(scree::shear_rate));
  state.number_density = doubles(m.to_host(scree::number_density));
  for (double& phi : state.number_density) phi /= solver.resolution().lattice_sum;
  state.volume = doubles(m.to_host(scree::volume));
  state.V = doubles(m.to_host(scree::segregation_velocity));
  state.D = doubles(m.to_host(scree::diffusivity));
  state.stress = stresses(m);
  auto const& physics = solver.settings().physics;
  add_rates(state, m, physics.transport.flux, physics.mechanics.gravity.direction());
  return state;
}

/// 1 where particles stand as densely as on the initial lattice.
struct RelativeDensity : scree::Scalar<"number density", "1"> {
  using reads = scree::Fields<scree::NumberDensity>;
  template <class I>
  static double of(I const& i, scree::Resolution const& resolution) {
    return double(i[scree::number_density]) / resolution.lattice_sum;
  }
};
/// Of particles.vtkhdf.
using FrameFields = scree::Fields<scree::Velocity, scree::Concentration, scree::ShearRate, scree::Stress,
                                  RelativeDensity, scree::SegregationVelocity, scree::Diffusivity, scree::SurfaceSet,
                                  scree::FreeSurfaceNormal, scree::WallNormal, scree::Identity>;

/// Material and walls now, with rates brought up to date.
template <class S>
scree::PointData frame_of(S& solver) {
  solver.update_rates();
  return scree::point_data_of(solver, FrameFields{}, scree::Bodies<scree::Material, scree::Wall>{});
}

/// What is recorded when; the recorder must outlive the observers.
template <class S>
typename S::Observers observers(Recorder& recorder, Options const& o) {
  return {scree::every<S>(o.output.history_interval, [&](S& s) { recorder.record_history(state_of(s)); }),
          scree::every<S>(o.output.frame_interval, [&](S& s) { recorder.record_frame(frame_of(s)); })};
}

template <class S>
RunFigures figures_of(S const& solver) {
  return {.time = solver.time(),
          .steps = solver.steps(),
          .neighbour_builds = solver.neighbour_builds(),
          .particles = solver.material().size(),
          .wall_particles = solver.wall().size(),
          .steps_by_limit = solver.limits(),
          .execution_space = S::policy::space::name()};
}

}  // namespace drum
