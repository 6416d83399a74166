// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "openings.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// The particle balance of the material: at_start + entered + added = present + left + removed.
struct Ledger {
  long at_start = 0;                   ///< when the solver was created
  long entered = 0, left = 0;          ///< through inlets and drains
  long added = 0, removed = 0;         ///< with add() and remove()
  long present = 0;                    ///< now
  std::vector<Passed> inlets, drains;  ///< particles that have passed each inlet or drain

  /// Whether no particle was lost or counted twice.
  bool balances() const { return at_start + entered + added == present + left + removed; }
};

/// Returns the particle balance of a solver in its current state.
template <class S>
Ledger ledger(S const& solver) {
  Ledger all;
  all.inlets = solver.entered(), all.drains = solver.left();
  for (Passed const& inlet : all.inlets) all.entered += inlet.particles;
  for (Passed const& drain : all.drains) all.left += drain.particles;
  all.at_start = solver.particles_at_start();
  all.added = solver.turnover().added - all.entered;
  all.removed = solver.turnover().removed - all.left;
  all.present = solver.whole().size();
  return all;
}

/// Throws std::runtime_error unless the ledger balances and the identities of the particles of the material are
/// distinct non-negative numbers, less than the number of all particles so far.
template <class S>
void check_ledger(S const& solver) {
  Ledger const all = ledger(solver);
  if (!all.balances() || all.added < 0 || all.removed < 0)
    throw std::runtime_error(detail::formatted(
        "scree: %ld particles at the start, %ld entered and %ld were added; %ld are present, %ld left and %ld were "
        "removed: these numbers do not balance",
        all.at_start, all.entered, all.added, all.present, all.left, all.removed));
  long const below = all.at_start + all.entered + all.added;
  std::vector<bool> known(std::size_t(below), false);
  for (int const number : solver.whole().values(fields::identity)) {
    if (number < 0 || number >= below || known[std::size_t(number)])
      throw std::runtime_error(detail::formatted(
          "scree: the identity %d occurs twice among the particles, or it is not from 0 to %ld", number, below - 1));
    known[std::size_t(number)] = true;
  }
}

}  // namespace scree
