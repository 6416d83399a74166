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
inline double available_memory() {
  double bytes = std::numeric_limits<double>::infinity();
#if defined(__linux__)
  if (std::FILE* const file = std::fopen("/proc/meminfo", "r")) {
    char line[128];
    double kibibytes = 0;
    while (std::fgets(line, sizeof line, file))
      if (std::sscanf(line, "MemAvailable: %lf", &kibibytes) == 1) bytes = 1024 * kibibytes;
    std::fclose(file);
  }
  ::rlimit limit{};
  double pages = 0;
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(file, "%lf", &pages) == 1)
        bytes = std::min(bytes, double(limit.rlim_cur) - pages * double(::sysconf(_SC_PAGESIZE)));
      std::fclose(file);
    }
#endif
  return std::clamp(bytes, 0.0, detail::assumed_memory());
}

/// Throws std::invalid_argument if the number of particles does not fit an int.
inline void check_number(double particles) {
  if (!(particles <= most_particles))
    throw std::invalid_argument(
        "scree: " + detail::short_text(particles) + " particles are more than the " + std::to_string(most_particles) +
        " that can be counted; a larger spacing or smaller lengths (check their unit) make fewer");
}
namespace detail {
inline void check_bytes(double particles, double needed, double there, char const* of_what) {
  if (needed > there)
    throw std::invalid_argument("scree: " + short_text(particles) + " particles need " + short_text(needed * 1e-9) +
                                " GB of " + of_what + ", " + short_text(there * 1e-9) +
                                " GB are there; a larger spacing or smaller lengths (check their unit) make fewer");
}
}  // namespace detail
/// The same if the host has too little memory for them.
inline void check_room(double particles, double bytes_of_each) {
  check_number(particles);
  detail::check_bytes(particles, particles * bytes_of_each, available_memory(), "memory");
}
/// A number of particles or values, converted to int.
inline int checked_count(std::size_t number) {
  check_number(double(number));
  return static_cast<int>(number);
}

}  // namespace scree
