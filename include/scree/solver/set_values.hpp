// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Checks of values that are given to particles.
namespace scree::detail {

/// Throws std::invalid_argument unless all volumes (m^dim) are above 0 and finite.
template <class Real>
[[gnu::cold]] void check_volumes(std::vector<Real> const& volumes, std::string const& of) {
  for (std::size_t k = 0; k < volumes.size(); ++k)
    check_setting(volumes[k] > 0 && std::isfinite(volumes[k]),
                  formatted("the volume (m^dim) of particle %zu of the %s", k, of.c_str()).c_str(), double(volumes[k]),
                  "above 0 and finite");
}

/// Throws std::invalid_argument unless these identities are those of a body, in any order.
template <class Body>
[[gnu::cold]] void check_identities(std::vector<int> numbers, Body const& body, std::string const& of) {
  auto allowed = body.to_host(fields::identity);
  std::sort(allowed.begin(), allowed.end()), std::sort(numbers.begin(), numbers.end());
  for (std::size_t k = 0; k < std::min(numbers.size(), allowed.size()); ++k) {
    bool const twice = k > 0 && numbers[k] == numbers[k - 1];
    if (numbers[k] != allowed[k])
      throw std::invalid_argument(
          formatted("scree: the identities of the %s may be exchanged among its particles, which have numbers from %d "
                    "to %d, and %d is given%s",
                    of.c_str(), allowed.front(), allowed.back(), numbers[k], twice ? " twice" : ""));
  }
}

}  // namespace scree::detail
