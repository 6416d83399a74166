// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"
#include "../fields/memory.hpp"
#include "../fields/standard.hpp"
#include "plan.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Some columns and the places of their values in a record: all values of a particle, one behind the other.
struct RecordColumns {
  static constexpr int most = 16;
  UntypedColumn columns[most];
  int place[most];  // of the first word
  int count = 0;
  int words = 0;  // of a record

  SCREE_FN UntypedColumn::Word* record(UntypedColumn::Word* all, int k) const {
    return all + std::size_t(k) * std::size_t(words);
  }
};

/// Writes the records of listed particles, shifted.
template <class P>
struct PackRecords {
  using Element = typename Element<P, value_t<P, Position>>::type;
  RecordColumns of;
  Column<P, Position> x;  // empty, unless positions are among the columns
  int place_of_x;
  Span<int const> numbers;
  ArraySpan<P, value_t<P, Position> const> shifts;
  UntypedColumn::Word* records;

  SCREE_FN void operator()(int k) const {
    auto* const record = of.record(records, k);
    int const i = numbers(k);
    for (int c = 0; c < of.count; ++c) {
      UntypedColumn const& column = of.columns[c];
      for (int w = 0; w < column.of_each; ++w)
        record[of.place[c] + w] = column.words[std::size_t(i) * std::size_t(column.of_each) + std::size_t(w)];
    }
    if (x.size() == 0) return;
    value_t<P, Position> moved = value_of(x(i));
    moved += value_of(shifts(k));
    Element const element = moved;
    // As bytes: a compiler may assume that words are no parts of a number.
    memcpy(record + place_of_x, static_cast<void const*>(&element), sizeof element);
  }
};
struct UnpackRecords {
  RecordColumns to;
  int first;  // particle
  UntypedColumn::Word* records;

  SCREE_FN void operator()(int k) const {
    auto const* const record = to.record(records, k);
    for (int c = 0; c < to.count; ++c) {
      UntypedColumn const& column = to.columns[c];
      for (int w = 0; w < column.of_each; ++w)
        column.words[std::size_t(first + k) * std::size_t(column.of_each) + std::size_t(w)] = record[to.place[c] + w];
    }
  }
};

/// The beginnings of messages in bytes, from those in records of some number of words.
inline std::vector<std::int64_t> in_bytes(std::vector<std::int64_t> starts, int words) {
  for (auto& start : starts) start *= std::int64_t(words) * std::int64_t(sizeof(UntypedColumn::Word));
  return starts;
}

/// The numbers of fields in the list of a body.
template <class... All, class... Fs>
std::vector<std::size_t> column_numbers_in(Fields<All...>, Fields<Fs...>) {
  auto const number = [](auto field) {
    std::size_t k = 0;
    (void)((std::is_same_v<decltype(field), All> || (++k, false)) || ...);
    return k;
  };
  return {number(Fs{})...};
}

}  // namespace detail

/// The numbers of some fields of a body among its columns.
template <class All, class List>
std::vector<std::size_t> column_numbers(List fields) {
  return detail::column_numbers_in(All{}, fields);
}

/// Sends fields of the particles of a plan: they are packed by one kernel, for up to 16 fields, and go to each part as
/// one contiguous message. Buffers are kept.
template <class P>
class Exchange {
 public:
  using TeamOf = Team<typename P::space>;

  /// Packs the columns with these numbers of the particles that leave here, and sends them. Bodies must not change
  /// before this returns.
  template <class Body>
  void send(TeamOf const& team, Plan<P> const& plan, Body const& body, std::vector<std::size_t> const& columns) {
    ProfilingRegion const region("scree::exchange");
    words_ = 0;
    for (std::size_t const column : columns) words_ += body.columns().untyped(column).of_each;
    auto const& space = body.space();
    Messages const sent = messages(to_send_, plan.sent()), received = messages(received_, plan.received());
    for_each_chunk(body, columns, [&](detail::RecordColumns const& some, int place_of_x) {
      detail::PackRecords<P> pack{some, {}, place_of_x, plan.numbers(), plan.shifts(), words_of(to_send_)};
      if (place_of_x >= 0) pack.x = body.column(fields::position);
      for_each_index(space, "scree::pack", 0, plan.sending(), pack);
    });
    space.fence("scree::packed");
    team.exchange(space, sent, received);
  }
  /// Writes what was sent here into a body, from particle `first` on.
  template <class Body>
  void receive(Plan<P> const& plan, Body const& body, std::vector<std::size_t> const& columns, int first) const {
    for_each_chunk(body, columns, [&](detail::RecordColumns const& some, int) {
      for_each_index(body.space(), "scree::unpack", 0, plan.receiving(),
                     detail::UnpackRecords{some, first, words_of(received_)});
    });
  }

 private:
  using Word = UntypedColumn::Word;
  using Bytes = Memory<memory_of<P>>;

  static Word* words_of(Bytes const& memory) { return reinterpret_cast<Word*>(memory.data()); }
  Messages messages(Bytes& memory, std::vector<std::int64_t> starts) const {
    starts = detail::in_bytes(std::move(starts), words_);
    auto const size = static_cast<std::size_t>(starts.back());
    if (memory.size() < size) memory = {}, memory = Bytes("scree::messages", size + size / 8);
    return {memory.data(), std::move(starts)};
  }
  /// Calls visit(columns, place of the position in a record or -1) for up to 16 columns at a time.
  template <class Body, class Visit>
  void for_each_chunk(Body const& body, std::vector<std::size_t> const& columns, Visit const& visit) const {
    int place = 0;
    for (std::size_t first = 0; first < columns.size(); first += detail::RecordColumns::most) {
      detail::RecordColumns some;
      some.words = words_;
      int place_of_x = -1;
      std::size_t const last = std::min(first + detail::RecordColumns::most, columns.size());
      for (std::size_t k = first; k < last; ++k, ++some.count) {
        some.columns[some.count] = body.columns().untyped(columns[k]);
        some.place[some.count] = place;
        if (some.columns[some.count].words == body.untyped(fields::position).words) place_of_x = place;
        place += some.columns[some.count].of_each;
      }
      visit(some, place_of_x);
    }
  }

  int words_ = 0;  // of a record
  Bytes to_send_, received_;
};

}  // namespace scree
