// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"
#include "../fields/columns.hpp"
#include "../fields/memory.hpp"
#include "../fields/standard.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// Functors that pack values of particles into messages and unpack them. A record has the values of one particle, one
// after the other.
namespace scree::detail {

using Word = UntypedColumn::Word;

/// A set of columns and the offsets of their values in a record.
struct RecordColumns {
  static constexpr int most = 16;
  struct Each {
    Word* words;
    int of_each, place;  // words per value, and offset of the value in a record
  };
  Each columns[most];
  int count = 0;

  bool has(void const* words) const {
    return std::any_of(columns, columns + count, [&](Each const& each) { return each.words == words; });
  }
  /// Calls copy(column, word of the value, word of the record) for the words that one thread copies when `sharing`
  /// threads share a record.
  template <class Copy>
  SCREE_FN void for_each_word(int thread, int sharing, Copy const& copy) const {
    int const end = columns[count - 1].place + columns[count - 1].of_each;
    for (int c = 0, w = columns[0].place + thread; w < end; w += sharing) {
      while (w >= columns[c].place + columns[c].of_each) ++c;
      copy(columns[c], w - columns[c].place, w);
    }
  }
};

/// Returns the number of threads that share each record. On a GPU eight threads read and write one memory sector.
template <class Space>
int threads_of_record(int records) {
  return on_host<Space> ? 1 : std::clamp(std::numeric_limits<int>::max() / std::max(records, 1), 1, 8);
}

/// The positions of the records of one body in messages with several bodies. The message for a rank has all records of
/// the first body, then all records of the next one.
struct RecordPlaces {
  static constexpr int most = 6;          // the largest number of bodies
  std::int64_t const* starts[most] = {};  // for each body, its first particle for each rank, and the end
  int words[most] = {};                   // per record of each body
  int bodies = 0, body = 0, ranks = 0;

  /// Returns the index of the first word of record k of the body.
  SCREE_FN std::size_t operator()(int k) const {
    auto place = std::int64_t(k) * words[body];
    if (bodies > 1) {
      int const rank = rank_of(k);
      for (int b = 0; b < bodies; ++b)
        if (b != body) place += words[b] * starts[b][b < body ? rank + 1 : rank];
    }
    return std::size_t(place);
  }

 private:
  SCREE_FN int rank_of(int k) const {
    int rank = 0;
    for (int end = ranks; end - rank > 1;) {
      int const middle = (rank + end) / 2;
      if (starts[body][middle] <= k)
        rank = middle;
      else
        end = middle;
    }
    return rank;
  }
};

/// Writes the records of listed particles to messages, with shifted positions. `sharing` threads share a record.
template <class P>
struct PackRecords {
  using Element = typename Element<P, value_t<P, Position>>::type;
  RecordColumns of;
  RecordPlaces places;
  Column<P, Position> x;  // empty unless positions are among the columns
  Span<int const> numbers;
  ArraySpan<P, value_t<P, Position> const> shifts;
  Word* messages;
  int sharing;  // threads per record

  SCREE_FN void operator()(int thread) const {
    int const k = thread / sharing, i = numbers(k);
    Word* const record = messages + places(k);
    of.for_each_word(thread % sharing, sharing, [&](auto const& column, int word, int place) {
      bool const is_position = x.size() > 0 && static_cast<void const*>(column.words) == x.data();
      record[place] = is_position ? moved(i, k, word)
                                  : column.words[std::size_t(i) * std::size_t(column.of_each) + std::size_t(word)];
    });
  }

 private:
  /// Returns one word of the shifted position of particle i.
  SCREE_FN Word moved(int i, int k, int word) const {
    value_t<P, Position> position = value_of(x(i));
    position += value_of(shifts(k));
    Element const element = position;
    Word words[sizeof(Element) / sizeof(Word)];
    // Copied as bytes, because a compiler may assume that words do not alias parts of a number.
    memcpy(words, static_cast<void const*>(&element), sizeof element);
    return words[word];
  }
};

struct UnpackRecords {
  RecordColumns to;
  RecordPlaces places;
  int first;  // the particle of record 0
  Word const* messages;
  int sharing;  // threads per record

  SCREE_FN void operator()(int thread) const {
    int const k = thread / sharing;
    Word const* const record = messages + places(k);
    to.for_each_word(thread % sharing, sharing, [&](auto const& column, int word, int place) {
      column.words[std::size_t(first + k) * std::size_t(column.of_each) + std::size_t(word)] = record[place];
    });
  }
};

}  // namespace scree::detail
