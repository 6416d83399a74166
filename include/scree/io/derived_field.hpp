// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/list.hpp"
#include "../fields/standard.hpp"
#include "../passes/resolution.hpp"

// Quantities that are computed from fields on the host when output is written. Particles do not store them.
namespace scree {

/// Whether F is a field that lists, in `reads`, the fields from which it is computed. Such a field also has a static
/// function `of(i, resolution)`, in which i gives the values of these fields at one particle: `i[velocity]`.
template <class F>
concept DerivedField = Field<F> && requires {
  typename F::reads;
};

/// Mean pressure, positive in compression.
struct Pressure : Scalar<"pressure", "Pa"> {
  using reads = Fields<Stress>;
  /// Returns the pressure of a particle (Pa).
  template <class I>
  static auto of(I const& i, Resolution const&) {
    auto const& sigma = i[fields::stress];
    return -(sigma[0] + sigma[1] + sigma[2]) / 3;
  }
};

namespace fields {
inline constexpr Pressure pressure{};
}  // namespace fields

}  // namespace scree
