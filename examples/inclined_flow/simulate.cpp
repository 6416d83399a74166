// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "layer.hpp"
#include "recorder.hpp"

#include <scree/io/body_series.hpp>

#include <numbers>

namespace inclined_flow {

namespace {

Bagnold flow_of(Options const& o) {
  auto law = beads(o.numerics.sound_speed, o.slope.diameter);
  law.mu_s = o.model.mu_s, law.mu_d = o.model.mu_d, law.I0 = o.model.I0;
  return {.law = law, .angle = o.slope.angle * std::numbers::pi / 180, .depth = o.slope.depth * o.slope.diameter};
}

/// Sums over a slice as thick as a row.
struct Slice {
  double number = 0, height = 0, velocity = 0, exact = 0, pressure = 0;
};

template <class S>
std::vector<Slice> slices_of(S const& solver, Bagnold const& flow, int rows) {
  auto const x = solver.material().to_host(scree::position);
  auto const u = solver.material().to_host(scree::velocity);
  auto const sigma = solver.material().to_host(scree::stress);
  std::vector<Slice> slices(std::size_t(rows) + 1);  // the last one: everything above
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const row = std::clamp(x[i][1] / flow.depth * rows, 0.0, double(rows));
    Slice& s = slices[std::size_t(row)];
    s.number += 1, s.height += x[i][1], s.velocity += u[i][0], s.exact += flow.velocity(x[i][1]);
    s.pressure -= (sigma[i][0] + sigma[i][1] + sigma[i][2]) / 3 / flow.pressure(x[i][1]);
  }
  return slices;
}

template <class S>
State state_of(S const& solver, Bagnold const& flow, int rows) {
  State state{.time = solver.time(), .steps = solver.steps(), .particles = solver.material().size()};
  double all = 0, exact = 0;
  for (Slice const& s : slices_of(solver, flow, rows)) {
    if (s.number == 0) continue;
    double const height = s.height / s.number / flow.depth, off = s.velocity / s.exact - 1;
    state.height.push_back(height);
    state.mean_velocity.push_back(s.velocity / s.number);
    state.exact_velocity.push_back(s.exact / s.number);
    state.pressure_ratio.push_back(s.pressure / s.number);
    if (height > 0.2 && height < 0.8 && std::abs(off) > std::abs(state.deviation)) state.deviation = off;
    all += s.velocity, exact += s.exact;
  }
  state.ratio = all / exact;
  return state;
}

}  // namespace

void simulate(support::Run<Options> const& run) {
  Options const& o = run.options;
  Bagnold const flow = flow_of(o);
  auto solver = layer(flow, {.rows = o.numerics.rows,
                             .viscosity_speed = o.model.viscosity_speed,
                             .cfl = o.numerics.cfl,
                             .start = o.slope.start});
  using S = decltype(solver);
  double const unit = flow.settling_time(), h = solver.resolution().smoothing_length;
  Recorder recorder(run, {.settling_time = unit,
                          .granular_viscosity = flow.differential_viscosity(),
                          .artificial_viscosity = scree::effective_viscosity(o.model.viscosity_speed, h, 2),
                          .wall_particles = solver.wall().size()});
  scree::BodySeries frames(run.output / "particles.vtkhdf", scree::Fields<scree::Velocity, scree::Pressure>{},
                           scree::Bodies<scree::Material>{},
                           {.single_precision = true, .provenance = {{"case", run.case_text}}});
  solver.run(o.output.duration * unit, {scree::every<S>(o.output.interval * unit, [&](S& s) {
               recorder.record(state_of(s, flow, o.numerics.rows));
               frames.append(s);
             })});
  recorder.finish(state_of(solver, flow, o.numerics.rows));
}

}  // namespace inclined_flow
