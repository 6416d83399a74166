// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

#include <type_traits>

namespace scree::detail {

/// Whether all components of a value are finite.
template <class T>
SCREE_FN bool is_finite(T const& value) {
  if constexpr (std::is_integral_v<T>) {
    return true;
  } else if constexpr (std::is_floating_point_v<T>) {
    return Kokkos::isfinite(value);
  } else {
    for (int k = 0; k < value.size(); ++k)
      if (!Kokkos::isfinite(value.data()[k])) return false;
    return true;
  }
}

/// Returns the value, or infinity if it is negative or NaN, because a maximum would ignore a NaN.
template <class Real>
SCREE_FN Real or_infinity(Real value) {
  constexpr Real infinity = Kokkos::Experimental::infinity_v<Real>;
  return value >= 0 ? value : +infinity;
}

}  // namespace scree::detail
