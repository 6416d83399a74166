// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "available_memory.hpp"
#include "compiled.hpp"

namespace scree {

SCREE_BODY double available_memory() {
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

SCREE_BODY void check_number(double particles) {
  if (!(particles <= most_particles))
    throw std::invalid_argument(
        "scree: " + detail::short_text(particles) + " particles are more than the " + std::to_string(most_particles) +
        " that can be counted; a larger spacing or smaller lengths (check their unit) make fewer");
}

SCREE_BODY void detail::check_bytes(double particles, double needed, double there, char const* of_what) {
  if (needed > there)
    throw std::invalid_argument("scree: " + short_text(particles) + " particles need " + short_text(needed * 1e-9) +
                                " GB of " + of_what + ", " + short_text(there * 1e-9) +
                                " GB are there; a larger spacing or smaller lengths (check their unit) make fewer");
}

SCREE_BODY void check_memory(double particles, double bytes_of_each) {
  check_number(particles);
  detail::check_bytes(particles, particles * bytes_of_each, available_memory(), "memory");
}

}  // namespace scree
