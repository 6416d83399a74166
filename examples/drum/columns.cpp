// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "columns.hpp"

#include <scree/io/in_space.hpp>

#include <cstddef>

namespace drum {

template <int Dim, class Real>
std::vector<double> Columns<Dim, Real>::doubles(std::vector<Real> const& values) {
  return {values.begin(), values.end()};
}
template <int Dim, class Real>
std::vector<double> Columns<Dim, Real>::component(std::vector<vector> const& vectors, int axis) {
  std::vector<double> values;
  if (Dim == 2 && axis == 1) return values;
  for (auto const& v : vectors) values.push_back(double(v[axis == 2 ? Dim - 1 : axis]));
  return values;
}
template <int Dim, class Real>
std::vector<double> Columns<Dim, Real>::stresses(std::vector<stress> const& given) {
  std::vector<double> all;
  for (auto const& sigma : given) {
    auto const entries = scree::in_space<Dim, scree::Stress>(sigma);
    all.insert(all.end(), entries.begin(), entries.end());
  }
  return all;
}
template <int Dim, class Real>
void Columns<Dim, Real>::add_rates(State& state, std::vector<vector> const& grad_C, std::vector<vector> const& grad_V,
                                   std::vector<Real> const& rate, scree::SegregationFlux const& flux,
                                   scree::GravityDirection const& down) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    double const by_V = -flux.value(state.C[i]) * double(down.component(grad_V[i]));
    double const by_C = -state.V[i] * flux.slope(state.C[i]) * double(down.component(grad_C[i]));
    state.gradient_V_rate.push_back(by_V);
    state.gradient_C_rate.push_back(by_C);
    state.diffusion_rate.push_back(double(rate[i]) - by_V - by_C);
  }
}

template struct Columns<2, float>;
template struct Columns<2, double>;
template struct Columns<3, float>;
template struct Columns<3, double>;

}  // namespace drum
