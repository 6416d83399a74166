// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/shapes/shape.hpp"
#include "sample.hpp"

namespace scree {

/// The mean of a field over a region.
template <class Value>
struct RegionMean {
  Value value;         ///< mean weighted by volume; NaN if there is no particle
  double volume = 0;   ///< volume of the particles in the region, m^dim
  long particles = 0;  ///< number of particles in the region
};

/// Returns the mean of a field of the material over the particles whose centres are in a shape (m), weighted by volume.
/// The field may be a derived field. Results of passes belong to the same state as for mean_at(). Computed on the host.
template <class S, Field F, Shape Region>
auto mean_in(S const& solver, F, Region const& region) {
  constexpr bool of_one_space = Region::dim == S::policy::dim;
  static_assert(of_one_space, "the region and the solver differ in their number of dimensions");
  if constexpr (of_one_space) {
    check_shape(region);
    auto const values = detail::sampled<F>(solver);
    using Value = typename decltype(values)::value_type;
    auto const places = detail::sampled<Position>(solver);
    auto const volumes = detail::sampled<Volume>(solver);
    RegionMean<Value> mean{detail::zero_of<Value>()};
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!region.contains(places[i])) continue;
      mean.value += volumes[i] * values[i];
      mean.volume += volumes[i];
      ++mean.particles;
    }
    if (mean.volume > 0)
      mean.value /= mean.volume;
    else
      mean.value = detail::nan_of<Value>();
    return mean;
  }
}

}  // namespace scree
