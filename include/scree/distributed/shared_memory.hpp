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

/// A Transport between the threads of one process: each part has a thread of its own.
class SharedMemory {
 public:
  /// The ends of all parts.
  static std::vector<SharedMemory> ends(int parts) {
    auto const hub = std::make_shared<Hub>(parts);
    std::vector<SharedMemory> all;
    for (int part = 0; part < parts; ++part) all.push_back({hub, part});
    return all;
  }

  int part() const { return part_; }
  int parts() const { return hub_->parts; }
  template <class Space>
  std::string name(Space const&) const {
    return "threads of one process";
  }

  void gather(void const* mine, std::size_t bytes, void* all) {
    hub_->offered[std::size_t(part_)] = {mine, bytes, nullptr};
    hub_->meet();
    read_together([&] {
      for (std::size_t q = 0; q < std::size_t(parts()); ++q) {
        check_size(int(q), std::int64_t(hub_->offered[q].bytes), std::int64_t(bytes));
        if (bytes > 0) std::memcpy(static_cast<std::byte*>(all) + q * bytes, hub_->offered[q].data, bytes);
      }
    });
  }
  template <class Space>
  void exchange(Space const& space, Messages const& sent, Messages const& received) {
    using InMemory = typename Space::memory_space;
    space.fence("scree::exchange");
    hub_->offered[std::size_t(part_)] = {nullptr, 0, &sent};
    hub_->meet();
    read_together([&] {
      for (int q = 0; q < parts(); ++q) {
        Messages const* const from = hub_->offered[std::size_t(q)].messages;
        check_size(q, from == nullptr ? -1 : from->size_for(part_), received.size_for(q));
        copy_bytes<InMemory, InMemory>(space, received.begin_for(q), from->begin_for(part_),
                                       std::size_t(received.size_for(q)));
      }
    });
  }
  void fail(std::string const& message) { hub_->fail("part " + std::to_string(part_) + " failed: " + message); }
  /// This part calls no more functions. Others that wait for it end with a message.
  void leave() { hub_->leave(part_); }

 private:
  struct Offer {
    void const* data = nullptr;
    std::size_t bytes = 0;
    Messages const* messages = nullptr;
  };
  /// Data that the threads share.
  class Hub {
   public:
    explicit Hub(int count) : parts(count), offered(std::size_t(count)) {}

    int const parts;
    std::vector<Offer> offered;  // of each part, from one meeting to the next

    /// Returns when all parts have called it.
    void meet() {
      std::unique_lock lock(mutex_);
      if (!left_.empty()) set_failed(left_);
      stop_if_failed();
      if (++waiting_ == parts) {
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
    void leave(int part) {
      std::lock_guard const lock(mutex_);
      left_ = "part " + std::to_string(part) + " has ended before the others";
      if (waiting_ > 0) set_failed(left_);
    }

   private:
    void set_failed(std::string const& message) {
      if (failed_.empty()) failed_ = "scree: " + message;
      all_here_.notify_all();
    }
    void stop_if_failed() const {
      if (!failed_.empty()) throw OtherPartFailed(failed_);
    }

    std::mutex mutex_;
    std::condition_variable all_here_;
    int waiting_ = 0;
    long meetings_ = 0;
    std::string failed_, left_;
  };

  SharedMemory(std::shared_ptr<Hub> hub, int part) : hub_(std::move(hub)), part_(part) {}
  /// Returns, or throws what `read` threw, when all have read: what a part offers must last until then.
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
    throw std::logic_error("scree: part " + std::to_string(from) + " sends " + std::to_string(there) +
                           " bytes, and part " + std::to_string(part_) + " expects " + std::to_string(here));
  }

  std::shared_ptr<Hub> hub_;
  int part_;
};

}  // namespace scree
