// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"

#include <algorithm>
#include <limits>

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

// Checks that memory is sufficient before particles are created. A system may grant more memory than it has, and kill
// the program when it is used.
namespace scree {

/// The largest number of particles of a body: numbers of particles are of type int.
inline constexpr int most_particles = std::numeric_limits<int>::max();

namespace detail {
inline double& assumed_memory() {
  static double bytes = std::numeric_limits<double>::infinity();
  return bytes;
}
}  // namespace detail
/// Limits the memory of the host and of a device that counts as free, in bytes: for a machine that is shared with other
/// programs, and for tests. Infinite: no limit.
inline void assume_free_memory(double bytes) { detail::assumed_memory() = bytes; }

/// Bytes that this process may still allocate, as far as the system reports it; infinite otherwise.
double available_memory();

/// Throws std::invalid_argument if the number of particles does not fit an int.
void check_number(double particles);
namespace detail {
void check_bytes(double particles, double needed, double there, char const* of_what);
}  // namespace detail
/// Throws std::invalid_argument if the number of particles does not fit an int, or if the host has too little memory
/// for them.
void check_memory(double particles, double bytes_of_each);
/// A number of particles or values, converted to int.
inline int checked_count(std::size_t number) {
  check_number(double(number));
  return static_cast<int>(number);
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "available_memory.ipp"
#endif
