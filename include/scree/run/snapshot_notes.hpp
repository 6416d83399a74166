// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"

#include <algorithm>
#include <cstring>

// Numbers of a program in a snapshot of its solver, and comparison of the texts about the case.
namespace scree {

/// Adds numbers under a name.
void add_numbers(Snapshot& snapshot, std::string const& name, std::vector<double> const& numbers);
/// The numbers under a name; empty if there are none.
std::vector<double> numbers_in(Snapshot const& snapshot, std::string const& name);

namespace detail {

/// Lines without comments (#) and blank lines, each after the [section] that it belongs to.
std::vector<std::string> lines_with_sections(std::string const& text);

}  // namespace detail

/// Notes of a snapshot: name and text.
using Notes = std::map<std::string, std::string>;

/// The differences between the notes of a run and those of a checkpoint, line by line: "case: 'spacing = 0.04' of the
/// checkpoint is missing", "case: 'spacing = 0.05' is new". Comments (#) and blank lines do not count; a line is
/// compared together with the [section] above it.
std::vector<std::string> changes_of_notes(Notes const& checkpoint, Notes const& run);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot_notes.ipp"
#endif
