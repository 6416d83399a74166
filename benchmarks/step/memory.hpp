// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/rows.hpp"

#include <algorithm>
#include <string_view>

namespace scree::bench {

/// Bytes of the memory of the execution space that Kokkos holds for its arrays, by Kokkos' own account.
class Memory {
 public:
  /// Starts counting.
  Memory() {
    all() = {};
    Kokkos::Tools::Experimental::set_allocate_data_callback(
        [](Kokkos_Profiling_SpaceHandle space, char const*, void const*, std::uint64_t bytes) {
          if (of_device(space)) add(double(bytes));
        });
    Kokkos::Tools::Experimental::set_deallocate_data_callback(
        [](Kokkos_Profiling_SpaceHandle space, char const*, void const*, std::uint64_t bytes) {
          if (of_device(space)) add(-double(bytes));
        });
  }
  double held() const { return all().held; }
  double most() const { return all().most; }

 private:
  struct Account {
    double held = 0, most = 0;
  };
  static Account& all() {
    static Account only;
    return only;
  }
  static void add(double bytes) {
    all().held += bytes;
    all().most = std::max(all().most, all().held);
  }
  static bool of_device(Kokkos_Profiling_SpaceHandle const& space) {
    return std::string_view(space.name) == Space::memory_space::name();
  }
};

}  // namespace scree::bench
