// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "divide.hpp"
#include "exchange.hpp"
#include "find.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree::detail {

/// Sends particles of one body to the ranks that own their positions, and keeps the others.
template <class P>
class Migration {
  using Shared = SharedByBodies<P>;

 public:
  /// Removes the particles that belong to other ranks, when every rank has all particles. Returns the numbers of the
  /// particles kept, in memory of this object.
  Array<P, int const> keep_own(Shared const& shared, AnyParticles<P>& body) {
    auto const own = staying(shared, body, 0, body.size());
    body.keep(own);
    return own;
  }
  /// Sends the particles that belong to other ranks, and receives the particles that belong to this rank.
  void run(Shared& shared, AnyParticles<P>& body) { send(shared, body, 0, body.size()); }
  /// Sends particles as run() does, but in eight rounds, so that messages need little memory when most particles leave.
  void run_for_share(Shared& shared, AnyParticles<P>& body) {
    int const rounds = 8, all = body.size();
    int seen = 0, sent = 0;
    for (int round = 1; round <= rounds; ++round) {
      int const count = static_cast<int>(std::int64_t(all) * round / rounds) - seen;
      int const from = seen - sent;
      seen += count;
      sent += send(shared, body, from, count);
    }
    leaving_ = {}, shared.exchange = {};  // later messages are shorter
  }

 private:
  /// Sends those particles in [from, from + count) that belong to other ranks. Returns the number sent.
  int send(Shared& shared, AnyParticles<P>& body, int from, int count) {
    auto const& team = shared.team;
    leaving_.make(body.space(), team, count, [&](int rank, int first, Span<int> const& numbers, auto const&) {
      int const wanted = rank == team.rank() ? -1 : rank;
      return FindOwnedBy<P>{body.column(fields::position), shared.planes(), wanted, first, numbers, from};
    });
    if (leaving_.everywhere() == 0) return 0;
    std::vector<std::size_t> columns(body.columns().kinds());
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = k;
    typename Exchange<P>::Shipments const all = {{leaving_, body, columns}};
    shared.exchange.send(team, all);
    body.keep(staying(shared, body, from, count));
    body.append(leaving_.receiving());
    shared.exchange.receive(all);
    shared.counts.migrated += leaving_.receiving();
    return leaving_.sending();
  }
  /// Returns the numbers, in memory order, of the particles that stay: all except those in [from, from + count) that
  /// belong to other ranks.
  Array<P, int const> staying(Shared const& shared, AnyParticles<P> const& body, int from, int count) {
    reserve(body.space(), kept_, "scree::kept", std::size_t(body.size()));
    FindStaying<P> const find{
        body.column(fields::position), shared.planes(), shared.team.rank(), from, from + count, kept_};
    return kept_.part(0, running_sum(body.space(), "scree::own", body.size(), find));
  }

  Plan<P> leaving_;
  Array<P, int> kept_;
};

}  // namespace scree::detail
