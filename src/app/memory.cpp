// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/memory.hpp>

#include <scree/core/available_memory.hpp>

namespace scree::app::detail {

std::string about_memory(double particles) {
  constexpr double least_bytes_of_particle = 200;  // no particle with its neighbours needs less, on any machine
  try {
    check_memory(particles, least_bytes_of_particle);
  } catch (std::invalid_argument const& error) {
    return std::string(error.what()).substr(std::string("scree: ").size());
  }
  return "";
}

}  // namespace scree::app::detail
