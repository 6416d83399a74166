// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../distributed/part_figures.hpp"

#include <string>
#include <vector>

namespace scree::app {

/// What a person should know about the parts of a case before it runs: the transport by its name, how fast it is, and
/// where each part computes.
std::string parts_text(std::string const& transport, Link const& link, std::vector<Place> const& places);

/// A table of what the steps of a run cost on each part of its case, per step.
std::string profile_text(std::vector<PartProfile> const& parts);

}  // namespace scree::app
