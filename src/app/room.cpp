// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/room.hpp>

#include <scree/core/room.hpp>

namespace scree::app::detail {

std::string about_room(double particles) {
  constexpr double least_bytes_of_particle = 200;  // no particle with its neighbours needs less, on any machine
  try {
    check_room(particles, least_bytes_of_particle);
  } catch (std::invalid_argument const& error) {
    return std::string(error.what()).substr(std::string("scree: ").size());
  }
  return "";
}

}  // namespace scree::app::detail
