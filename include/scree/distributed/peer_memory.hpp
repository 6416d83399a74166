// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the headers and the library of MPI

#include "marks.hpp"
#include "mpi.hpp"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// A Transport between ranks on one host: each rank writes its messages directly to memory of the receiving ranks, and
/// MPI carries only small control messages. With EventMark the host does not wait for kernels: copies follow the
/// kernels in the queue of the instance, and the queues of the ranks wait for each other. `Mark` is a type from
/// marks.hpp. `Blocks` provides memory that other processes can map (CudaBlocks, HostBlocks):
///   name                           a description of the kind of memory, for output
///   Handle                         bytes that another process needs to map a block
///   Block(size), data(), handle()  a block of this process
///   Mapped(handle), data()         a block of another process
///   copy(space, to, from, bytes)   begins a copy, in order with the kernels of the instance
template <class Blocks, class Mark = detail::FencedMark>
class PeerMemory {
  using Handle = typename Blocks::Handle;

 public:
  /// Exchanges the marks of the ranks. All ranks construct this object together.
  explicit PeerMemory(Mpi mpi) : mpi_(std::move(mpi)), shared_(std::make_shared<Shared>(mpi_)) {}

  int rank() const { return mpi_.rank(); }
  int ranks() const { return mpi_.ranks(); }
  template <class Space>
  std::string name(Space const& space) const {
    return std::string(Blocks::name) + Mark::words(space);
  }

  void gather(void const* mine, std::size_t bytes, void* all) { mpi_.gather(mine, bytes, all); }
  template <class Space>
  void exchange(Space const& space, Messages const& sent, Messages const& received) {
    if (sent.size_for(rank()) != received.size_for(rank()))
      throw std::logic_error("scree: a rank sends itself a message of another size than it expects");
    write(space, sent, received, offer(sent, received));
    confirm(sent, received);
    take(space, received);
  }
  void fail(std::string const& message) { mpi_.fail(message); }

 private:
  /// The memory of the receiver for one message.
  struct Offer {
    Handle handle;
    std::int64_t generation, start, size;
  };
  /// The block and the marks of another rank.
  struct Peer {
    std::int64_t generation = -1;
    std::unique_ptr<typename Blocks::Mapped> block;
    std::unique_ptr<typename Mark::Found> wrote, took;
  };
  /// The memory and marks of this rank, and those of the other ranks. A block that has become too small is kept,
  /// because other ranks may still have it mapped.
  struct Shared {
    explicit Shared(Mpi& mpi)
        : communicator(mpi.communicator()), peers(std::size_t(mpi.ranks())), wrote(std::size_t(mpi.ranks())) {
      std::size_t const count = peers.size(), here = std::size_t(mpi.rank());
      std::vector<Handles> mine, all(count * count);
      for (auto& each : wrote) {
        each = std::make_unique<Mark>();
        mine.push_back({each->handle(), took->handle()});
      }
      mpi.gather(mine.data(), count * sizeof(Handles), all.data());
      for (std::size_t q = 0; q < count; ++q) {
        if (q == here) continue;
        peers[q].wrote = std::make_unique<typename Mark::Found>(all[q * count + here].wrote);
        peers[q].took = std::make_unique<typename Mark::Found>(all[q * count + here].took);
      }
    }
    Shared(Shared const&) = delete;
    Shared& operator=(Shared const&) = delete;
    /// Frees memory only after all copies have ended and all ranks have unmapped it. After an exception, or after
    /// MPI_Finalize, the other ranks may not get here, so memory and marks are kept until the process ends.
    ~Shared() {
      int finalised = 0;
      MPI_Finalized(&finalised);
      if (std::uncaught_exceptions() == 0 && finalised == 0) {
        if (Kokkos::is_initialized()) Kokkos::fence("scree::peers");
        peers.clear();
        MPI_Barrier(communicator);
      } else {
        for (auto& each : peers) (void)each.block.release();
        (void)block.release();
        for (auto& each : old) (void)each.release();
        for (auto& each : wrote) (void)each.release();
        (void)took.release();
      }
    }
    struct Handles {
      typename Mark::Handle wrote, took;
    };
    MPI_Comm communicator;
    std::unique_ptr<typename Blocks::Block> block;
    std::vector<std::unique_ptr<typename Blocks::Block>> old;
    std::size_t size = 0;
    std::int64_t generation = 0;
    std::vector<Peer> peers;
    std::vector<std::unique_ptr<Mark>> wrote;               ///< set after the last message to each rank
    std::unique_ptr<Mark> took = std::make_unique<Mark>();  // set after the copies of all received messages
  };

  /// Sends the addresses of the receive buffers to the ranks that send messages to this rank, and receives the
  /// addresses from the ranks that this rank sends messages to.
  std::vector<Offer> offer(Messages const& sent, Messages const& received) {
    grow(std::size_t(received.starts.back()));
    auto const count = static_cast<std::size_t>(ranks());
    std::vector<Offer> mine(count), theirs(count);
    mpi_.trade(
        [&](int q) -> Words {
          if (received.size_for(q) == 0) return {};
          mine[std::size_t(q)] = {shared_->block->handle(), shared_->generation, received.starts[std::size_t(q)],
                                  received.size_for(q)};
          return {&mine[std::size_t(q)], sizeof(Offer)};
        },
        [&](int q) -> Words {
          return sent.size_for(q) == 0 ? Words{} : Words{&theirs[std::size_t(q)], sizeof(Offer)};
        });
    for (int q = 0; q < ranks(); ++q)
      if (q != rank() && sent.size_for(q) > 0 && theirs[std::size_t(q)].size != sent.size_for(q))
        throw std::logic_error("scree: rank " + std::to_string(rank()) + " sends " + std::to_string(sent.size_for(q)) +
                               " bytes, and rank " + std::to_string(q) + " expects " +
                               std::to_string(theirs[std::size_t(q)].size));
    return theirs;
  }
  /// Tells the receivers of messages from this rank that the marks are set, and waits until the senders to this rank
  /// have set theirs.
  void confirm(Messages const& sent, Messages const& received) {
    auto const count = static_cast<std::size_t>(ranks());
    std::vector<char> out(count, 1), in(count, 0);
    mpi_.trade(
        [&](int q) -> Words {
          return sent.size_for(q) == 0 ? Words{} : Words{&out[std::size_t(q)], 1};
        },
        [&](int q) -> Words {
          return received.size_for(q) == 0 ? Words{} : Words{&in[std::size_t(q)], 1};
        });
  }
  /// Begins to write messages to the buffers of the other ranks, after those ranks have taken the previous messages.
  template <class Space>
  void write(Space const& space, Messages const& sent, Messages const& received, std::vector<Offer> const& offers) {
    for (int q = 0; q < ranks(); ++q) {
      auto const size = std::size_t(sent.size_for(q));
      if (size == 0) continue;
      if (q == rank()) {
        Blocks::copy(space, received.begin_for(q), sent.begin_for(q), size);
        continue;
      }
      Peer& peer = shared_->peers[std::size_t(q)];
      std::byte* const room = mapped(peer, offers[std::size_t(q)]);
      peer.took->pass(space);
      Blocks::copy(space, room, sent.begin_for(q), size);
      shared_->wrote[std::size_t(q)]->set(space);
    }
  }
  /// Begins to copy the messages for this rank out of the shared block, after they have arrived.
  template <class Space>
  void take(Space const& space, Messages const& received) {
    bool any = false;
    for (int q = 0; q < ranks(); ++q) {
      if (q == rank() || received.size_for(q) == 0) continue;
      shared_->peers[std::size_t(q)].wrote->pass(space);
      Blocks::copy(space, received.begin_for(q), shared_->block->data() + received.starts[std::size_t(q)],
                   std::size_t(received.size_for(q)));
      any = true;
    }
    if (any) shared_->took->set(space);
  }
  void grow(std::size_t size) {
    if (size <= shared_->size) return;
    if (shared_->block) shared_->old.push_back(std::move(shared_->block));
    shared_->size = size + size / 2;  // growth by a half keeps the sum of all blocks below 4.5 times the size
    shared_->block = std::make_unique<typename Blocks::Block>(shared_->size);
    ++shared_->generation;
  }
  static std::byte* mapped(Peer& peer, Offer const& offer) {
    if (peer.generation != offer.generation) {
      Kokkos::fence("scree::peers");  // waits for copies to the old block
      peer.block.reset();
      peer.block = std::make_unique<typename Blocks::Mapped>(offer.handle);
      peer.generation = offer.generation;
    }
    return peer.block->data() + offer.start;
  }
  using Words = Mpi::Words;

  Mpi mpi_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace scree

#endif
