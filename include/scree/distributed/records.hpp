// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"
#include "../fields/memory.hpp"
#include "../fields/standard.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

// Loops that pack values of particles into messages, and unpack them. A record has the values of one particle, one
// behind the other.
namespace scree::detail {

using Word = UntypedColumn::Word;

/// Some columns and the places of their values in a record.
struct RecordColumns {
  static constexpr int most = 16;
  struct Each {
    Word* words;
    int of_each, place;  // words of a value, and the first of them in a record
  };
  Each columns[most];
  int count = 0;
};

/// The places of the records of one body in messages of several bodies. The message for a part has all its records of
/// the first body, then those of the next one.
struct RecordPlaces {
  static constexpr int most = 6;          // bodies
  std::int64_t const* starts[most] = {};  // of each body: its first particle for each part, and the end
  int words[most] = {};                   // of a record
  int bodies = 0, body = 0, parts = 0;

  /// The first word of record k of the body.
  SCREE_FN std::size_t operator()(int k) const {
    auto place = std::int64_t(k) * words[body];
    if (bodies > 1) {
      int const part = part_of(k);
      for (int b = 0; b < bodies; ++b)
        if (b != body) place += words[b] * starts[b][b < body ? part + 1 : part];
    }
    return std::size_t(place);
  }

 private:
  SCREE_FN int part_of(int k) const {
    int part = 0;
    for (int end = parts; end - part > 1;) {
      int const middle = (part + end) / 2;
      if (starts[body][middle] <= k)
        part = middle;
      else
        end = middle;
    }
    return part;
  }
};

/// Writes the records of listed particles, shifted.
template <class P>
struct PackRecords {
  using Element = typename Element<P, value_t<P, Position>>::type;
  RecordColumns of;
  RecordPlaces places;
  Column<P, Position> x;  // empty, unless positions are among the columns
  int place_of_x;
  Span<int const> numbers;
  ArraySpan<P, value_t<P, Position> const> shifts;
  Word* messages;

  SCREE_FN void operator()(int k) const {
    Word* const record = messages + places(k);
    int const i = numbers(k);
    for (int c = 0; c < of.count; ++c) {
      auto const& [words, of_each, place] = of.columns[c];
      for (int w = 0; w < of_each; ++w)
        record[place + w] = words[std::size_t(i) * std::size_t(of_each) + std::size_t(w)];
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
  RecordPlaces places;
  int first;  // particle
  Word const* messages;

  SCREE_FN void operator()(int k) const {
    Word const* const record = messages + places(k);
    for (int c = 0; c < to.count; ++c) {
      auto const& [words, of_each, place] = to.columns[c];
      for (int w = 0; w < of_each; ++w)
        words[std::size_t(first + k) * std::size_t(of_each) + std::size_t(w)] = record[place + w];
    }
  }
};

}  // namespace scree::detail
