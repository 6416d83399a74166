// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "particles.hpp"

namespace scree {

SCREE_BODY void detail::require_values(std::string_view field, std::size_t values, int owned) {
  if (values != std::size_t(owned))
    throw std::invalid_argument("scree: " + std::string(field) + " needs one value for each owned particle: " +
                                std::to_string(owned) + ", not " + std::to_string(values));
}

SCREE_BODY void detail::require_values_from(std::string_view field, std::size_t values, int first, int owned) {
  if (first < 0 || values != std::size_t(owned - first))
    throw std::invalid_argument("scree: " + std::string(field) + " needs one value for each particle from number " +
                                std::to_string(first) + " on");
}

SCREE_BODY void detail::refuse_column(std::string_view field) {
  throw std::logic_error("scree: these particles do not carry the field '" + std::string(field) + "'");
}

}  // namespace scree
