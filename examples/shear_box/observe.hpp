// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "recorder.hpp"

#include <scree/scree.hpp>

// From a solver to what the recorder understands.
namespace shear_box {

template <class S>
State state_of(S const& solver, double period) {
  auto const C = solver.material().to_host(scree::concentration);
  return {.time = solver.time() / period, .steps = solver.steps(), .C = {C.begin(), C.end()}};
}

namespace detail {
// In 2D the plane is drawn as x, z.
template <class Vectors>
void append(std::vector<double>& xyz, Vectors const& vectors) {
  for (auto const& v : vectors) {
    constexpr int last = std::remove_cvref_t<decltype(v)>::RowsAtCompileTime - 1;
    xyz.insert(xyz.end(), {double(v[0]), last == 2 ? double(v[1]) : 0, double(v[last])});
  }
}
/// Values of the material followed by zeros for the walls.
template <class Values>
auto padded(Values const& values, std::size_t all) {
  using Out = std::conditional_t<std::is_integral_v<typename Values::value_type>, std::int32_t, double>;
  std::vector<Out> result(values.begin(), values.end());
  result.resize(all, 0);
  return result;
}
template <class Vectors>
std::vector<double> padded_vectors(Vectors const& vectors, std::size_t all) {
  std::vector<double> xyz;
  append(xyz, vectors);
  xyz.resize(3 * all, 0.0);
  return xyz;
}
}  // namespace detail

template <class S>
Frame frame_of(S& solver) {
  solver.update_diagnostics();
  auto const& material = solver.material();
  auto const& wall = solver.wall();
  auto const n = static_cast<std::size_t>(material.size());
  auto const all = n + static_cast<std::size_t>(wall.size());
  Frame frame;
  frame.time = solver.time();
  detail::append(frame.xyz, material.to_host(scree::position));
  detail::append(frame.xyz, wall.to_host(scree::position));
  frame.free_surface_normal = detail::padded_vectors(material.to_host(scree::free_surface_normal), all);
  frame.wall_normal = detail::padded_vectors(material.to_host(scree::wall_normal), all);
  frame.C = detail::padded(material.to_host(scree::concentration), all);
  frame.V = detail::padded(material.to_host(scree::segregation_velocity), all);
  frame.D = detail::padded(material.to_host(scree::diffusivity), all);
  frame.surface_set = detail::padded(material.to_host(scree::surface_set), all);
  frame.identity = detail::padded(material.to_host(scree::identity), n);
  for (int number : wall.to_host(scree::identity)) frame.identity.push_back(number);
  frame.body.assign(n, 0);
  frame.body.resize(all, 1);
  return frame;
}

/// What is recorded when; the recorder must outlive the observers.
template <class S>
typename S::Observers observers(Recorder& recorder, Options const& o) {
  double const T = o.geometry.period;
  auto compared = recorder.compared_times();
  for (double& time : compared) time *= T;
  return {scree::every<S>(o.output.history_interval * T, [&, T](S& s) { recorder.record_history(state_of(s, T)); }),
          scree::every<S>(o.output.frame_interval * T, [&](S& s) { recorder.record_frame(frame_of(s)); }),
          scree::at<S>(compared, [&, T](S& s) { recorder.keep_profile(state_of(s, T)); })};
}

template <class S>
RunFigures figures_of(S const& solver, double period) {
  return {.time = solver.time() / period,
          .steps = solver.steps(),
          .neighbour_builds = solver.neighbour_builds(),
          .particles = solver.material().size(),
          .wall_particles = solver.wall().size(),
          .steps_by_limit = solver.limits(),
          .execution_space = S::policy::space::name()};
}

}  // namespace shear_box
