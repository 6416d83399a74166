// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "unset_fields.hpp"

namespace scree::detail {

SCREE_BODY void refuse_unset(std::string_view name, std::string_view unit, std::string_view name_of_body) {
  throw std::invalid_argument(
      formatted("scree: %s (%s) of the %s is read by passes or the integrator, and nothing gives or computes it: give "
                "it before the first step, with set(); zeros too, if they are meant",
                std::string(name).c_str(), std::string(unit).c_str(), std::string(name_of_body).c_str()));
}

}  // namespace scree::detail
