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

/// Messages to or from each rank, stored one after the other: the message of rank q is at [starts[q], starts[q + 1]).
/// The bytes are in the memory of the execution space.
struct Messages {
  std::byte* bytes = nullptr;        ///< the first byte of the first message
  std::vector<std::int64_t> starts;  ///< offsets of the messages in bytes; one more than there are ranks

  /// Returns the number of bytes to or from a rank.
  std::int64_t size_for(int rank) const {
    return starts[static_cast<std::size_t>(rank) + 1] - starts[static_cast<std::size_t>(rank)];
  }
  /// Returns the address of the first byte to or from a rank.
  std::byte* begin_for(int rank) const { return bytes + starts[static_cast<std::size_t>(rank)]; }
};

/// Whether a class can carry messages between the ranks of one case. All ranks call the same functions in the same
/// order, each from one thread.
///   rank()                       returns the number of this rank, from 0
///   ranks()                      returns the number of ranks
///   gather(mine, bytes, all)     copies the same number of bytes in host memory from each rank to every rank, in
///                                the order of the ranks
///   exchange(space, sent, received)
///                                sends a message to each rank, itself included; later kernels of the instance find
///                                all received messages, and may change `sent`; earlier kernels of the instance that
///                                write `sent` may still be running. Throws if sizes do not agree
///   fail(message)                ends all ranks: ranks that wait or that call any function later throw
///                                OtherRankFailed
///   name(space)                  optional: returns a description of how messages travel
/// Sizes agree if received.size_for(q) on rank p equals sent.size_for(p) on rank q. A transport throws if sizes do not
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

/// The exception thrown on all ranks other than the one that failed.
struct OtherRankFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
