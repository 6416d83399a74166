// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../system/any_pass.hpp"

namespace scree::detail {

// Lists of fields for System::columns: the fields of a body that a pass reads from neighbours, and the fields of a body
// that it writes.
template <class Pass>
struct ReadOfNeighbours {
  template <class Body>
  using of = typename Pass::template reads_j<Body>;
};
template <class Pass>
struct WrittenBy {
  template <class Body>
  using of = typename Pass::template writes<Body>;
};
/// Whether a pass is one of the library, whose value() is its value for a system. A class that derives from such a pass
/// may have a function run() of its own.
template <class Pass>
inline constexpr bool gives_value = false;
template <class Sys, class Pass>
void run_pass(void const* pass, void* system) {
  static_cast<Pass const*>(pass)->run(*static_cast<Sys*>(system));
}
/// Returns the value of a pass for a system, which refers to the pass: the result of value() for a pass of the library;
/// for any other pass a value whose loops are run() of the pass.
template <class Sys, class Pass>
AnyPass any_pass(Pass const& pass) {
  if constexpr (gives_value<Pass>)
    return pass.template value<Sys>();
  else
    return {.loops = run_pass<Sys, Pass>, .pass = &pass};
}
/// Runs a single pass.
template <class Sys, class Pass>
void run_alone(Sys& system, Pass const& pass) {
  AnyPass const value = any_pass<Sys>(pass);
  system.run({&value, 1});
}

}  // namespace scree::detail
