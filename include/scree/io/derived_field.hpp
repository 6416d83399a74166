// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/list.hpp"
#include "../fields/standard.hpp"
#include "../passes/resolution.hpp"

// Quantities that are computed from fields when they are written, on the host. No particle stores them.
namespace scree {

/// A field that names the fields it is computed from in `reads` and has a static function `of(i, resolution)`, where i
/// offers their values at one particle: `i[velocity]`.
template <class F>
concept DerivedField = Field<F> && requires {
  typename F::reads;
};

/// Mean pressure, positive in compression.
struct Pressure : Scalar<"pressure", "Pa"> {
  using reads = Fields<Stress>;
  /// The pressure of a particle, Pa.
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
