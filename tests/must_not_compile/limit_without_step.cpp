// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: is a function of the largest value, which returns a step
#include <scree/passes/limit.hpp>

auto limit_of(double h) {
#ifdef FIXED
  return scree::limit("speed", scree::Magnitude<scree::Velocity>{}, [h](double u) { return h / u; });
#else
  return scree::limit("speed", scree::Magnitude<scree::Velocity>{}, h);
#endif
}
