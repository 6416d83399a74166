// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../distributed/part_figures.hpp"

#include <string>
#include <vector>

namespace scree::app {

/// Describes the parts of a case before it runs: the name and the speed of the transport, and the place of each part.
std::string parts_text(std::string const& transport, Link const& link, std::vector<Place> const& places);

/// A table of the cost of a step: time, messages and waiting of each part.
std::string profile_text(std::vector<PartProfile> const& parts);

}  // namespace scree::app
