// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"

#include <algorithm>
#include <cstring>

// Numbers that a program stores in a snapshot of its solver, and a comparison of the notes on the case.
namespace scree {

/// Adds numbers to a snapshot under a name.
void add_numbers(Snapshot& snapshot, std::string const& name, std::vector<double> const& numbers);
/// Returns the numbers in a snapshot under a name, or an empty vector if there are none.
std::vector<double> numbers_in(Snapshot const& snapshot, std::string const& name);

namespace detail {

/// Returns the lines of a text, without comments (#) and blank lines, each preceded by its [section].
std::vector<std::string> lines_with_sections(std::string const& text);

}  // namespace detail

/// The notes of a snapshot: texts by name.
using Notes = std::map<std::string, std::string>;

/// Returns the differences between the notes of a checkpoint and of a run, line by line: "case: 'spacing = 0.04' of the
/// checkpoint is missing", "case: 'spacing = 0.05' is new". Comments (#) and blank lines are ignored; a line is
/// compared together with the [section] above it.
std::vector<std::string> changes_of_notes(Notes const& checkpoint, Notes const& run);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot_notes.ipp"
#endif
