// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/setting.hpp"
#include "response.hpp"

#include <cmath>
#include <stdexcept>

namespace scree::detail {

SCREE_BODY void check_of_law(char const* name, double value) {
  check_setting(value > 0 && std::isfinite(value), name, value, "above 0 and finite");
}

SCREE_BODY void check_answer(AnyStress const& answer, char const* function, double trial, char const* what) {
  double const pressure = pressure_of(answer);
  if (!(pressure > 0) || !std::isfinite(answer.norm()))
    throw std::invalid_argument(
        formatted("scree: %s of the law gives %.6g as %s, where the pressure is %.6g Pa; it must "
                  "be above 0 and finite, for the material to resist",
                  function, pressure, what, trial));
}

SCREE_BODY void check_no_tension(AnyStress const& answer, double trial) {
  if (!(pressure_of(answer) >= 0))
    throw std::invalid_argument(formatted(
        "scree: `cohesionless` of the law is true, but admissible() keeps a tension of %.6g Pa of %.6g Pa; a law "
        "that bears tension sets it to false",
        -pressure_of(answer), trial));
}

}  // namespace scree::detail
