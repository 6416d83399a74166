// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/point_data_of.hpp"
#include "../system/periodic.hpp"

#include <cmath>
#include <type_traits>
#include <vector>

// Functions shared by the probes, which read the particles on the host.
namespace scree::detail {

/// Returns a value of a field in double precision.
template <class Value>
auto in_double(Value const& value) {
  if constexpr (std::is_arithmetic_v<Value>)
    return double(value);
  else
    return value.template cast<double>().eval();
}
template <class Value>
using Doubled = decltype(in_double(std::declval<Value const&>()));

/// Returns the values of a field of the material on all ranks, in double precision. The field may be a derived field.
template <Field F, class S>
auto sampled(S const& solver) {
  using P = typename S::policy;
  static_assert(carries<F, std::remove_cvref_t<decltype(solver.material())>>,
                "the material does not carry this field: a field is carried if a pass reads or writes it; for output "
                "alone, name a pass that writes it in `diagnostics`");
  std::vector<Doubled<typename host_value<P, F>::type>> values;
  auto const order = solver.whole().order();
  for (auto const& value : order.of(host_values<F>(solver.material(), solver.resolution())))
    values.push_back(in_double(value));
  return values;
}

template <class Value>
Value zero_of() {
  if constexpr (std::is_arithmetic_v<Value>)
    return 0;
  else
    return Value::Zero();
}
template <class Value>
Value nan_of() {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  if constexpr (std::is_arithmetic_v<Value>)
    return nan;
  else
    return Value::Constant(nan);
}

/// Returns the offset (m) from the nearest periodic image of y to x.
template <class X>
X nearest_offset(X const& x, X const& y, std::vector<Period> const& periods) {
  X offset = x - y;
  for (Period const& period : periods) {
    double const length = period.high - period.low;
    offset[period.axis] -= length * std::round(offset[period.axis] / length);
  }
  return offset;
}

}  // namespace scree::detail
