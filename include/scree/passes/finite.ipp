// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "finite.hpp"

namespace scree::detail {

SCREE_BODY std::string text_of_numbers(double const* numbers, int count) {
  std::string text;
  for (int k = 0; k < count; ++k) text += formatted("%s%.9g", k == 0 ? "" : ", ", numbers[k]);
  return count == 1 ? text : "(" + text + ")";
}

}  // namespace scree::detail
