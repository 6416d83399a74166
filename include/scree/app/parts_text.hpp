// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../distributed/link.hpp"
#include "../distributed/place.hpp"

#include <string>
#include <vector>

namespace scree::app {

/// What a person should know about the parts of a case before it runs: the transport by its name, how fast it is, and
/// where each part computes.
std::string parts_text(std::string const& transport, Link const& link, std::vector<Place> const& places);

/// The same, measured. All parts call it together.
template <class Space>
std::string parts_text(Team<Space> const& team, Space const& space) {
  Link const link = measured_link(team, space);
  return parts_text(team.name(space), link, team.gather(place_of(space)));
}

}  // namespace scree::app
