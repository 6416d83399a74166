// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../distributed/rank_figures.hpp"

#include <string>
#include <vector>

namespace scree::app {

/// Returns a description of the ranks of a case, to be printed before the run: the name and the speed of the transport,
/// and the host and device of each rank.
std::string ranks_text(std::string const& transport, Link const& link, std::vector<Place> const& places);

/// Returns a table of the cost of a step: the time, the messages and the waiting time of each rank.
std::string profile_text(std::vector<RankProfile> const& ranks);

}  // namespace scree::app
