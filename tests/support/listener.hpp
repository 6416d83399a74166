// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace scree::test {

/// Listens to Kokkos as a profiler does, to its end.
class Listener {
 public:
  Listener() : before_(Kokkos::Tools::Experimental::get_callbacks()) {
    namespace Tools = Kokkos::Tools::Experimental;
    open_.clear(), all_.clear(), loops_outside_.clear();
    Tools::set_push_region_callback([](char const* name) { open_.push_back(name), all_.insert(name); });
    Tools::set_pop_region_callback([] { open_.pop_back(); });
    auto const begin = [](char const* name, std::uint32_t, std::uint64_t*) {
      if (open_.empty()) loops_outside_.insert(name);
    };
    Tools::set_begin_parallel_for_callback(begin);
    Tools::set_begin_parallel_reduce_callback(begin);
    Tools::set_begin_parallel_scan_callback(begin);
  }
  Listener(Listener const&) = delete;
  Listener& operator=(Listener const&) = delete;
  ~Listener() { Kokkos::Tools::Experimental::set_callbacks(before_); }

  std::set<std::string> const& regions() const { return all_; }
  std::set<std::string> const& loops_outside() const { return loops_outside_; }
  bool all_closed() const { return open_.empty(); }

 private:
  Kokkos::Tools::Experimental::EventSet before_;
  static inline std::vector<std::string> open_;
  static inline std::set<std::string> all_, loops_outside_;
};

}  // namespace scree::test
