// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is no Transport: it needs rank\(\), ranks\(\), gather
#include <scree/distributed/team.hpp>

#include <Kokkos_Core.hpp>

#include <cstring>

struct Alone {
  int rank() const { return 0; }
  int ranks() const { return 1; }
  void gather(void const* mine, std::size_t bytes, void* all) { std::memcpy(all, mine, bytes); }
  template <class Space>
  void exchange(Space const&, scree::Messages const&, scree::Messages const&) {}
#ifdef FIXED
  void fail(std::string const&) {}
#endif
};
using Space = Kokkos::DefaultHostExecutionSpace;
scree::Team<Space> team() { return scree::Team<Space>(Alone()); }
