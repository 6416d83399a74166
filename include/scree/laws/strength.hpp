// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {

/// Returns whether a law yields on a cone with neither friction nor cohesion, so that the material flows like a liquid;
/// for ByGroup, whether the law of any group does. Returns false for laws without a member `cone`.
template <class Law>
bool is_without_strength(Law const& law) {
  if constexpr (requires { law.cone.friction + law.cone.cohesion; }) {
    return law.cone.friction == 0 && law.cone.cohesion == 0;
  } else if constexpr (requires { law.of(law.groups()); }) {
    for (int k = 0; k < law.groups(); ++k)
      if (is_without_strength(law.of(k))) return true;
  }
  return false;
}

}  // namespace scree
