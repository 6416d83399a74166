// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/checks/packing.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

// The packing of the grains at the end of a verification case, printed beside the other figures of the case.
namespace scree::test {

/// Prints the packing of the grains that carry pressure with the next assertion, and returns it.
template <class S>
Packing show_packing(S const& solver) {
  Packing const found = solver.packing();
  UNSCOPED_INFO("packing " << found.text());
  return found;
}

/// Whether grains that rest under pressure fill the space that they had at the start to 3 %. Their own weight
/// compresses them by less than 1 % in all cases that ask, and the sum over a lattice is up to 0.6 % above 1.
inline bool is_packed_as_at_rest(Packing const& packing) {
  return packing.full > 0 && std::abs(packing.density - 1) < 0.03;
}

}  // namespace scree::test
