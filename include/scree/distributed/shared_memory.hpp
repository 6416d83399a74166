// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/memory.hpp"
#include "transport.hpp"

#include <condition_variable>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// A Transport between threads of one process: each rank has its own thread.
class SharedMemory {
 public:
  /// Returns one transport object for each rank; the objects are connected with each other.
  static std::vector<SharedMemory> ends(int ranks) {
    auto const hub = std::make_shared<Hub>(ranks);
    std::vector<SharedMemory> all;
    for (int rank = 0; rank < ranks; ++rank) all.push_back({hub, rank});
    return all;
  }

  int rank() const { return rank_; }
  int ranks() const { return hub_->ranks; }
  template <class Space>
  std::string name(Space const&) const {
    return "threads of one process";
  }

  void gather(void const* mine, std::size_t bytes, void* all) {
    hub_->offered[std::size_t(rank_)] = {mine, bytes, nullptr};
    hub_->meet();
    read_together([&] {
      for (std::size_t q = 0; q < std::size_t(ranks()); ++q) {
        check_size(int(q), std::int64_t(hub_->offered[q].bytes), std::int64_t(bytes));
        if (bytes > 0) std::memcpy(static_cast<std::byte*>(all) + q * bytes, hub_->offered[q].data, bytes);
      }
    });
  }
  template <class Space>
  void exchange(Space const& space, Messages const& sent, Messages const& received) {
    using InMemory = typename Space::memory_space;
    space.fence("scree::exchange");
    hub_->offered[std::size_t(rank_)] = {nullptr, 0, &sent};
    hub_->meet();
    read_together([&] {
      for (int q = 0; q < ranks(); ++q) {
        Messages const* const from = hub_->offered[std::size_t(q)].messages;
        check_size(q, from == nullptr ? -1 : from->size_for(rank_), received.size_for(q));
        copy_bytes<InMemory, InMemory>(space, received.begin_for(q), from->begin_for(rank_),
                                       std::size_t(received.size_for(q)));
      }
    });
  }
  void fail(std::string const& message) { hub_->fail("rank " + std::to_string(rank_) + " failed: " + message); }
  /// Declares that this rank calls no more functions. Ranks that wait for it throw OtherRankFailed.
  void leave() { hub_->leave(rank_); }

 private:
  struct Offer {
    void const* data = nullptr;
    std::size_t bytes = 0;
    Messages const* messages = nullptr;
  };
  /// Data that the threads share.
  class Hub {
   public:
    explicit Hub(int count) : ranks(count), offered(std::size_t(count)) {}

    int const ranks;
    std::vector<Offer> offered;  // by each rank, valid from one barrier to the next

    /// Waits until all ranks have called this function (a barrier).
    void meet() {
      std::unique_lock lock(mutex_);
      if (!left_.empty()) set_failed(left_);
      stop_if_failed();
      if (++waiting_ == ranks) {
        waiting_ = 0;
        ++meetings_;
        all_here_.notify_all();
        return;
      }
      long const meeting = meetings_;
      all_here_.wait(lock, [&] { return meetings_ != meeting || !failed_.empty(); });
      if (meetings_ == meeting) stop_if_failed();
    }
    void fail(std::string const& message) {
      std::lock_guard const lock(mutex_);
      set_failed(message);
    }
    void leave(int rank) {
      std::lock_guard const lock(mutex_);
      left_ = "rank " + std::to_string(rank) + " has ended before the others";
      if (waiting_ > 0) set_failed(left_);
    }

   private:
    void set_failed(std::string const& message) {
      if (failed_.empty()) failed_ = "scree: " + message;
      all_here_.notify_all();
    }
    void stop_if_failed() const {
      if (!failed_.empty()) throw OtherRankFailed(failed_);
    }

    std::mutex mutex_;
    std::condition_variable all_here_;
    int waiting_ = 0;
    long meetings_ = 0;
    std::string failed_, left_;
  };

  SharedMemory(std::shared_ptr<Hub> hub, int rank) : hub_(std::move(hub)), rank_(rank) {}
  /// Calls `read`, waits until all ranks have read, because the data that a rank offers must last until then, and
  /// rethrows the exception of `read`, if any.
  template <class Read>
  void read_together(Read const& read) {
    std::exception_ptr failure;
    try {
      read();
    } catch (...) {
      failure = std::current_exception();
    }
    hub_->meet();
    if (failure) std::rethrow_exception(failure);
  }
  void check_size(int from, std::int64_t there, std::int64_t here) {
    if (there == here) return;
    throw std::logic_error("scree: rank " + std::to_string(from) + " sends " + std::to_string(there) +
                           " bytes, and rank " + std::to_string(rank_) + " expects " + std::to_string(here));
  }

  std::shared_ptr<Hub> hub_;
  int rank_;
};

}  // namespace scree
