// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "pass.hpp"

namespace scree {

/// Runs a list of passes in order. Only fields that the passes have changed are copied to ghosts.
template <class Sys, detail::AnyTuple Passes>
void run_passes(Sys& system, Passes const& passes) {
  constexpr bool is_empty = detail::tuple_size<Passes> == 0;
  if constexpr (!is_empty)
    detail::with_values(
        [&](auto const&... each) {
          detail::AnyPass const values[] = {detail::any_pass<Sys>(each)...};
          system.run(values);
        },
        passes);
}

}  // namespace scree
