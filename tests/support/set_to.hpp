// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/list.hpp>

#include <type_traits>

namespace scree::test {

/// Sets all entries of a field to one value for each particle.
template <Field F>
struct SetTo {
  double number = 0;
  using reads = Fields<>;
  using writes = Fields<F>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    using T = std::remove_cvref_t<decltype(out[F{}])>;
    if constexpr (std::is_arithmetic_v<T>)
      out[F{}] = T(number);
    else
      for (int k = 0; k < out[F{}].size(); ++k) out[F{}].data()[k] = typename T::Scalar(number);
  }
};

}  // namespace scree::test
