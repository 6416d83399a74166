// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree {

/// Returns the k-th argument of a program as a number, or `otherwise` if the argument is missing:
///     double const duration = argument<double>(argc, argv, 1, 0.5);
/// Throws std::invalid_argument, with the index and the text of the argument, if the argument is not a finite number
/// (for an integer, a whole number) or is followed by other text, such as a unit.
template <class T>
T argument(int argc, char const* const* argv, int k, std::type_identity_t<T> otherwise) {
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, int>, "argument<T> reads numbers of type double or int");
  if (argc <= k) return otherwise;
  char* end = nullptr;
  double const value = std::strtod(argv[k], &end);
  bool good = end != argv[k] && *end == '\0' && std::isfinite(value);
  if constexpr (std::is_same_v<T, int>) good = good && value == std::rint(value) && std::abs(value) < 2e9;
  if (good) return static_cast<T>(value);
  throw std::invalid_argument("argument " + std::to_string(k) + " must be a " +
                              (std::is_same_v<T, int> ? "whole number" : "number") + ", not '" + argv[k] + "'");
}

}  // namespace scree
