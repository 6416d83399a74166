// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/exact_sum.hpp"
#include "../fields/shared_points.hpp"
#include "rank_figures.hpp"
#include "transport.hpp"

#include <Kokkos_Timer.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// The ranks of one case, from the viewpoint of one rank: a Transport and reductions. The results of reductions are the
/// same on all ranks and for any number of ranks. All ranks call the same functions in the same order. Copies of a team
/// share the transport.
template <class Space>
class Team {
 public:
  /// Constructs a team that uses a transport. A class that is not a Transport does not compile.
  template <class T>
  explicit Team(T transport) : transport_(std::make_shared<Holder<T>>(std::move(transport))) {
    static_assert(Transport<T, Space>,
                  "this is no Transport: it needs rank(), ranks(), gather(mine, bytes, all), exchange(space, sent, "
                  "received) and fail(message)");
  }

  /// Returns the number of this rank, from 0.
  int rank() const { return transport_->rank(); }
  /// Returns the number of ranks.
  int ranks() const { return transport_->ranks(); }
  /// Returns the share of this rank, for functions that fill shapes: each rank then begins with its own particles.
  ShareOfRank share() const { return {rank(), ranks()}; }
  /// Returns a value from each rank, in the order of the ranks.
  template <class T>
  std::vector<T> gather(T const& mine) const {
    static_assert(std::is_trivially_destructible_v<T>, "values travel as bytes");
    std::vector<T> all(static_cast<std::size_t>(ranks()));
    gather_bytes(&mine, sizeof(T), all.data());
    return all;
  }
  /// Gathers the same number of values from each rank, in the order of the ranks.
  template <class T>
  std::vector<T> gather(std::vector<T> const& mine) const {
    static_assert(std::is_trivially_destructible_v<T>, "values travel as bytes");
    std::vector<T> all(mine.size() * static_cast<std::size_t>(ranks()));
    gather_bytes(mine.data(), mine.size() * sizeof(T), static_cast<void*>(all.data()));
    return all;
  }
  /// Sends a message to each rank and counts the messages, see Transport. Throws the exceptions of the transport.
  void exchange(Space const& space, Messages const& sent, Messages const& received) const {
    Kokkos::Timer const timer;
    transport_->exchange(space, sent, received);
    Traffic& traffic = transport_->traffic;
    traffic.exchanging += timer.seconds();
    ++traffic.exchanges;
    for (int q = 0; q < ranks(); ++q) {
      if (q == rank() || sent.size_for(q) == 0) continue;
      ++traffic.messages;
      traffic.bytes += sent.size_for(q);
    }
  }
  /// Ends all ranks of the case. On other ranks that are threads, calls that wait and later calls throw OtherRankFailed
  /// with the message; MPI processes are aborted.
  void fail(std::string const& message) const { transport_->fail(message); }
  /// Returns the amount of data that this rank has sent so far, and the time taken.
  Traffic const& traffic() const { return transport_->traffic; }
  /// Resets the counts to these values. Checks call this function so that their messages are not included in the counts
  /// of the run.
  void count_from(Traffic const& traffic) const { transport_->traffic = traffic; }
  /// Returns a description of how messages travel, for output.
  std::string name(Space const& space) const { return transport_->name(space); }

  /// Returns, on every rank, the largest value over all ranks.
  template <class T>
  T largest(T const& mine) const {
    auto const all = gather(mine);
    return *std::max_element(all.begin(), all.end());
  }
  /// Returns, on every rank, the smallest value over all ranks.
  template <class T>
  T smallest(T const& mine) const {
    auto const all = gather(mine);
    return *std::min_element(all.begin(), all.end());
  }
  /// Returns the sums of integers over all ranks, element by element.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> const& mine) const {
    auto const all = gather(mine);
    std::vector<std::int64_t> total(mine.size(), 0);
    for (std::size_t k = 0; k < all.size(); ++k) total[k % mine.size()] += all[k];
    return total;
  }
  std::int64_t sum(std::int64_t mine) const { return sum(std::vector{mine}).front(); }
  /// Returns the sums of the terms on all ranks, element by element.
  std::vector<double> sum(std::vector<ExactSum> const& mine) const {
    auto const all = gather(mine);
    std::vector<ExactSum> total(mine.size());
    for (std::size_t k = 0; k < all.size(); ++k) total[k % mine.size()] += all[k];
    std::vector<double> values;
    for (ExactSum const& each : total) values.push_back(each.value());
    return values;
  }
  double sum(ExactSum const& mine) const { return sum(std::vector{mine}).front(); }

 private:
  void gather_bytes(void const* mine, std::size_t bytes, void* all) const {
    Kokkos::Timer const timer;
    transport_->gather(mine, bytes, all);
    transport_->traffic.gathering += timer.seconds();
    ++transport_->traffic.gathers;
  }

  struct AnyTransport {
    virtual ~AnyTransport() = default;
    virtual std::string name(Space const& space) const = 0;
    virtual int rank() const = 0;
    virtual int ranks() const = 0;
    virtual void gather(void const* mine, std::size_t bytes, void* all) = 0;
    virtual void exchange(Space const& space, Messages const& sent, Messages const& received) = 0;
    virtual void fail(std::string const& message) = 0;
    Traffic traffic = {};
  };
  template <class T>
  struct Holder : AnyTransport {
    explicit Holder(T given) : transport(std::move(given)) {}
    std::string name(Space const& space) const override {
      if constexpr (requires { transport.name(space); })
        return transport.name(space);
      else
        return "a transport of the program";
    }
    int rank() const override { return transport.rank(); }
    int ranks() const override { return transport.ranks(); }
    void gather(void const* mine, std::size_t bytes, void* all) override { transport.gather(mine, bytes, all); }
    void exchange(Space const& space, Messages const& sent, Messages const& received) override {
      transport.exchange(space, sent, received);
    }
    void fail(std::string const& message) override { transport.fail(message); }
    T transport;
  };

  std::shared_ptr<AnyTransport> transport_;
};

}  // namespace scree
