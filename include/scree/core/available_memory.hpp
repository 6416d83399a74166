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

// Checks for sufficient memory before particles are created. An operating system may grant more memory than it has, and
// kill the program when the memory is used.
namespace scree {

/// The largest number of particles in a body; particles are counted in an int.
inline constexpr int most_particles = std::numeric_limits<int>::max();

namespace detail {
inline double& assumed_memory() {
  static double bytes = std::numeric_limits<double>::infinity();
  return bytes;
}
}  // namespace detail
/// Limits the memory that counts as free, in bytes, both on the host and on a device. The limit serves for tests and
/// for a machine that is shared with other programs; an infinite value means no limit.
inline void assume_free_memory(double bytes) { detail::assumed_memory() = bytes; }

/// Returns the number of bytes that this process may still allocate, at most the limit of assume_free_memory(). If the
/// system does not report the number, returns that limit, which is infinite by default.
double available_memory();

/// Throws std::invalid_argument if the number of particles does not fit in an int.
void check_number(double particles);
namespace detail {
void check_bytes(double particles, double needed, double there, char const* of_what);
}  // namespace detail
/// Throws std::invalid_argument if the number of particles does not fit in an int, or if the host has too little memory
/// for the particles.
void check_memory(double particles, double bytes_of_each);
/// Returns a number of particles or values as an int. Throws std::invalid_argument if the number does not fit in an
/// int.
inline int checked_count(std::size_t number) {
  check_number(double(number));
  return static_cast<int>(number);
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "available_memory.ipp"
#endif
