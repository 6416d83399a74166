// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// Bytes for or from each rank, one message behind the other: that of rank q is at [starts[q], starts[q + 1]). The
/// bytes are in the memory of the execution space.
struct Messages {
  std::byte* bytes = nullptr;        ///< the first byte of the first message
  std::vector<std::int64_t> starts;  ///< one more than there are ranks

  /// The number of bytes for or from a rank.
  std::int64_t size_for(int rank) const {
    return starts[static_cast<std::size_t>(rank) + 1] - starts[static_cast<std::size_t>(rank)];
  }
  /// The first byte for or from a rank.
  std::byte* begin_for(int rank) const { return bytes + starts[static_cast<std::size_t>(rank)]; }
};

/// Carries messages between the ranks of one case. All ranks call the same functions in the same order, each from one
/// thread.
///   rank()                       the number of this rank, from 0
///   ranks()                      the number of ranks
///   gather(mine, bytes, all)     each rank gives the same number of bytes in host memory, and gets those of all, in
///                                the order of the ranks
///   exchange(space, sent, received)
///                                sends a message to each rank, also to itself; later kernels of the instance find all
///                                that were received, and may change `sent`; kernels of the instance that write `sent`
///                                may not have ended. Throws where sizes do not agree
///   fail(message)                ends all ranks: those that wait, and those that call any function later, throw
///                                OtherRankFailed
///   name(space)                  optional: returns a description of how messages travel
/// Sizes agree: received.size_for(q) on rank p is sent.size_for(p) on rank q. A transport throws where sizes do not
/// agree.
template <class T, class Space>
concept Transport = requires(T transport, Space const& space, void const* mine, std::size_t bytes, void* all,
                             Messages const& messages, std::string const& text) {
  { transport.rank() } -> std::convertible_to<int>;
  { transport.ranks() } -> std::convertible_to<int>;
  transport.gather(mine, bytes, all);
  transport.exchange(space, messages, messages);
  transport.fail(text);
};

/// Thrown on the ranks that did not fail themselves.
struct OtherRankFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
