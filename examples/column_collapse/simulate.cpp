// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "column.hpp"
#include "floor.hpp"
#include "profile.hpp"
#include "recorder.hpp"

#include <scree/io/body_series.hpp>

namespace column_collapse {

namespace {

Column column_of(Options const& o) {
  return {.aspect = o.geometry.aspect,
          .width = o.geometry.width,
          .spacing = o.geometry.width / o.numerics.across,
          .reach = floor_reach(o)};
}
Physics physics_of(Options const& o) {
  auto const law = beads(column_of(o), mu_for(o.model.friction_at_rest), mu_for(o.model.friction_at_speed));
  return {.law = law, .viscosity_speed = o.model.viscosity_speed, .cfl = o.numerics.cfl};
}

template <class S>
State state_of(S const& solver, Options const& o) {
  Column const column = column_of(o);
  State state{.time = solver.time(), .steps = solver.steps(), .particles = solver.material().size()};
  for (auto const& u : solver.material().to_host(scree::velocity)) state.speed = std::max(state.speed, u.norm());
  Profile const profile(solver.material().to_host(scree::position), column.spacing);
  for (std::size_t k = 0; k < profile.slices(); ++k) {
    state.distance.push_back(profile.middle(k));
    state.depth.push_back(profile.depth(k));
  }
  state.reach = profile.reach(o.output.reading_depth * column.height());
  state.summit = profile.summit();
  return state;
}

}  // namespace

template <int Dim>
void simulate(support::Run<Options> const& run) {
  Options const& o = run.options;
  auto solver = at_rest<Formulation<Dim>>(column_of(o), physics_of(o));
  using S = decltype(solver);
  double const unit = column_of(o).fall_time();
  Recorder recorder(run);
  scree::BodySeries frames(run.output / "particles.vtkhdf", scree::Fields<scree::Velocity, scree::Pressure>{},
                           scree::Bodies<scree::Material>{},
                           {.single_precision = true, .provenance = {{"case", run.case_text}}});
  solver.run(o.output.duration * unit, {scree::every<S>(o.output.interval * unit, [&](S& s) {
               recorder.record(state_of(s, o));
               frames.append(s);
             })});
  recorder.finish(state_of(solver, o), solver.wall().size());
}
template void simulate<2>(support::Run<Options> const&);
template void simulate<3>(support::Run<Options> const&);

}  // namespace column_collapse
