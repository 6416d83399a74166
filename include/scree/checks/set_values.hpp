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

/// Throws std::invalid_argument unless all volumes (m^dim) are above 0 and finite; `of` names the particles.
template <class Real>
[[gnu::cold]] void check_volumes(std::vector<Real> const& volumes, std::string const& of) {
  for (std::size_t k = 0; k < volumes.size(); ++k)
    check_setting(volumes[k] > 0 && std::isfinite(volumes[k]),
                  formatted("the volume (m^dim) of particle %zu of %s", k, of.c_str()).c_str(), double(volumes[k]),
                  "above 0 and finite");
}

/// Throws std::invalid_argument unless all identities differ and are 0 or more; `of` names the particles.
[[gnu::cold]] inline void check_identities(std::vector<int> numbers, std::string const& of) {
  std::sort(numbers.begin(), numbers.end());
  if (!numbers.empty())
    check_setting(numbers.front() >= 0, ("the identity of a particle of " + of).c_str(), numbers.front(), "0 or more");
  auto const twice = std::adjacent_find(numbers.begin(), numbers.end());
  if (twice != numbers.end())
    throw std::invalid_argument(formatted("scree: two particles of %s have the identity %d", of.c_str(), *twice));
}

}  // namespace scree::detail
