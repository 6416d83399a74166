// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

#include <scree/core/room.hpp>

namespace support {

/// No particle with its neighbours needs less, on any machine.
inline constexpr double least_bytes_of_particle = 200;

/// Refuses, at `key`, a case of more particles than can be counted or than there is memory for.
template <class T>
void require_room(Schema<T>& schema, std::string key, std::function<double(T const&)> particles) {
  schema.complain({std::move(key), [particles](T const& options) -> std::string {
                     try {
                       scree::check_room(particles(options), least_bytes_of_particle);
                     } catch (std::invalid_argument const& error) {
                       return std::string(error.what()).substr(std::string("scree: ").size());
                     }
                     return "";
                   }});
}

}  // namespace support
