// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/cloud.hpp"

#include <scree/fields/particles.hpp>
#include <scree/fields/standard.hpp>
#include <scree/segregation/conservative.hpp>

#include <cstdint>

// Bodies whose fields vary from particle to particle, so that no timing uses zeros.
namespace scree::bench {

/// Values of a field are uniform within `width` of the mean, independently for each component.
struct Range {
  double mean = 1, width = 0.5;
};
template <Field F>
Range range_of(F) {
  return {};
}
inline Range range_of(Velocity) { return {0, 0.1}; }
inline Range range_of(Stress) { return {-1000, 500}; }
inline Range range_of(Concentration) { return {0.5, 0.4}; }
inline Range range_of(Density) { return {1500, 50}; }
inline Range range_of(SegregationPotential) { return {0, 2}; }
inline Range range_of(OddCorrection) { return {0, 1}; }

/// Uniform in [-1, 1), from the number of the particle and of the component (splitmix64).
inline double even(std::uint64_t number, std::uint64_t component) {
  std::uint64_t z = number * 64 + component + 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return double((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

template <class Body, Field F>
void fill_at_random(Body& body, F field, Range const& range) {
  using P = typename Body::policy;
  using Value = value_t<P, F>;
  using Number = typename P::real;
  constexpr std::size_t components = sizeof(Value) / sizeof(Number);
  std::uint64_t const salt = std::hash<std::string_view>()(F::name);
  std::vector<Value> values(static_cast<std::size_t>(body.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto* const numbers = reinterpret_cast<Number*>(&values[i]);
    for (std::size_t c = 0; c < components; ++c) numbers[c] = Number(range.mean + range.width * even(i, salt + c));
  }
  body.from_host(field, values);
}

/// Gives a body the particles of a cloud and random values of the given fields.
template <class Body, int Dim, class... Fs>
void populate(Body& body, Cloud<Dim> const& cloud, Fields<Fs...>) {
  using namespace fields;
  using Real = typename Body::policy::real;
  body.resize(static_cast<int>(cloud.points.size()));
  (fill_at_random(body, Fs{}, range_of(Fs{})), ...);
  double const volume_of_each = std::pow(cloud.spacing, Dim);
  fill_at_random(body, volume, {volume_of_each, 0.05 * volume_of_each});
  body.from_host(position, cast<Real>(cloud.points));
}

}  // namespace scree::bench
