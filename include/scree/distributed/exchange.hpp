// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "plan.hpp"
#include "records.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Returns the offsets of messages in bytes, given their offsets in records of `words` words.
inline std::vector<std::int64_t> in_bytes(std::vector<std::int64_t> starts, int words) {
  for (auto& start : starts) start *= std::int64_t(words) * std::int64_t(sizeof(Word));
  return starts;
}

}  // namespace detail

/// The fields of one body to send: numbers of columns, and a plan that lists the particles.
template <class P>
struct Shipment {
  /// Selects columns of a body by number. The plan must outlive the shipment.
  Shipment(Plan<P> const& of, AnyParticles<P> const& body, std::vector<std::size_t> numbers)
      : plan(&of), particles(&body.columns()), x(body.column(fields::position)), columns(std::move(numbers)) {
    for (std::size_t const column : columns) words += particles->untyped(column).of_each;
  }
  /// Selects all columns in a list of column numbers.
  Shipment(Plan<P> const& of, AnyParticles<P> const& body, ColumnNumbers numbers)
      : Shipment(of, body, std::vector<std::size_t>(numbers.begin(), numbers.end())) {}
  Plan<P> const* plan;
  detail::UntypedParticles<typename P::space> const* particles;
  Column<P, Position> x;
  std::vector<std::size_t> columns;
  int words = 0;  ///< words of a record
};

/// Sends fields of the particles listed in plans. Each rank receives one contiguous message with the fields of up to
/// six bodies; one kernel launch packs up to 16 fields of a body. The buffers are reused.
template <class P>
class Exchange {
 public:
  using TeamOf = Team<typename P::space>;
  using Shipments = std::vector<Shipment<P>>;
  static constexpr std::size_t most = detail::RecordPlaces::most;  ///< the largest number of bodies in an exchange

  /// Packs the fields of all shipments and sends them.
  void send(TeamOf const& team, Shipments const& all) {
    ProfilingRegion const region("scree::exchange");
    auto const& space = all.front().particles->space();
    Messages const sent = messages(to_send_, all, &Plan<P>::sent),
                   received = messages(received_, all, &Plan<P>::received);
    for_each_chunk(all, &Plan<P>::sent_there, [&](auto const& each, auto const& some, auto const& at) {
      int const count = each.plan->sending(), sharing = detail::threads_of_record<typename P::space>(count);
      detail::PackRecords<P> pack{some, at, {}, each.plan->numbers(), each.plan->shifts(), words_of(to_send_), sharing};
      if (some.has(each.x.data())) pack.x = each.x;
      for_each_index(space, "scree::pack", 0, count * sharing, pack);
    });
    team.exchange(space, sent, received);
  }
  /// Writes the received values to the last particles of each body, which are the ghosts of the body if there are any.
  void receive(Shipments const& all) const {
    for_each_chunk(all, &Plan<P>::received_there, [&](auto const& each, auto const& some, auto const& at) {
      int const count = each.plan->receiving(), sharing = detail::threads_of_record<typename P::space>(count);
      for_each_index(each.particles->space(), "scree::unpack", 0, count * sharing,
                     detail::UnpackRecords{some, at, each.particles->extent() - count, words_of(received_), sharing});
    });
  }

 private:
  using Bytes = Memory<memory_of<P>>;
  using Starts = std::vector<std::int64_t> const& (Plan<P>::*)() const;
  using StartsThere = std::int64_t const* (Plan<P>::*)() const;

  static detail::Word* words_of(Bytes const& memory) { return reinterpret_cast<detail::Word*>(memory.data()); }
  static Messages messages(Bytes& memory, Shipments const& all, Starts starts_of) {
    std::vector<std::int64_t> starts;
    for (auto const& each : all) {
      auto const own = detail::in_bytes((each.plan->*starts_of)(), each.words);
      starts.resize(own.size(), 0);
      for (std::size_t q = 0; q < own.size(); ++q) starts[q] += own[q];
    }
    auto const size = static_cast<std::size_t>(starts.back());
    if (memory.size() < size) memory = {}, memory = Bytes("scree::messages", size + size / 8);
    return {memory.data(), std::move(starts)};
  }
  /// Calls visit(shipment, columns, record places) for at most 16 columns of a body at a time.
  template <class Visit>
  static void for_each_chunk(Shipments const& all, StartsThere starts_of, Visit const& visit) {
    if (all.size() > most) throw std::logic_error("scree: an exchange sends at most six bodies");
    detail::RecordPlaces places;
    for (auto const& each : all) {
      places.starts[places.bodies] = (each.plan->*starts_of)();
      places.words[places.bodies++] = each.words;
      places.ranks = static_cast<int>(each.plan->sent().size()) - 1;
    }
    for (auto const& each : all) {
      auto const& columns = each.columns;
      int place = 0;
      for (std::size_t first = 0; first < columns.size(); first += detail::RecordColumns::most) {
        detail::RecordColumns some;
        std::size_t const last = std::min(first + detail::RecordColumns::most, columns.size());
        for (std::size_t k = first; k < last; ++k) {
          auto const [words, of_each] = each.particles->untyped(columns[k]);
          some.columns[some.count++] = {words, of_each, place};
          place += of_each;
        }
        visit(each, some, places);
      }
      ++places.body;
    }
  }

  Bytes to_send_, received_;
};

}  // namespace scree
