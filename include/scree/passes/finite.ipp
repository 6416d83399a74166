// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "finite.hpp"

namespace scree::detail {

SCREE_BODY std::string text_of_numbers(std::vector<double> const& numbers) {
  std::string text;
  for (double const number : numbers) text += formatted("%s%.9g", text.empty() ? "" : ", ", number);
  return numbers.size() == 1 ? text : "(" + text + ")";
}

}  // namespace scree::detail
