// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "../files/text_reader.hpp"
#include "stl.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

namespace scree {

namespace detail {

/// Returns an unsigned number or a float from four bytes, in little-endian order.
template <class T>
T from_bytes(char const* bytes) {
  static_assert(sizeof(T) == 4);
  std::uint32_t bits = 0;
  for (unsigned k = 0; k < 4; ++k) bits |= std::uint32_t(static_cast<unsigned char>(bytes[k])) << (8 * k);
  return std::bit_cast<T>(bits);
}

inline constexpr std::size_t stl_head = 84, stl_triangle = 50;  // bytes; the head ends with the number of triangles

/// Returns the size in bytes of a binary file with the number of triangles that this file states.
SCREE_BODY std::size_t binary_stl_size(std::string_view bytes) {
  return stl_head + stl_triangle * from_bytes<std::uint32_t>(bytes.data() + stl_head - 4);
}

SCREE_BODY Triangles read_binary_stl(std::string_view bytes, std::string const& name) {
  Triangles result{.name = name};
  std::size_t const count = (bytes.size() - stl_head) / stl_triangle;
  check_triangles(name, double(count));
  result.vertices.reserve(3 * count);
  for (std::size_t t = 0; t < count; ++t) {
    char const* at = bytes.data() + stl_head + t * stl_triangle + 12;  // after its normal
    int const first = int(result.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      Vec<3, double> x;
      for (int axis = 0; axis < 3; ++axis, at += 4) x[axis] = double(from_bytes<float>(at));
      if (!x.allFinite())
        throw std::runtime_error(name + ", triangle " + std::to_string(t + 1) +
                                 ": a coordinate is not a finite number");
      result.vertices.push_back(x);
    }
    result.corners.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// Whether a word is a keyword in lower or upper case.
SCREE_BODY bool is_word(std::string_view word, std::string_view keyword) {
  if (word.size() != keyword.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (word[k] != keyword[k] && word[k] != char(keyword[k] - 'a' + 'A')) return false;
  return true;
}

/// Advances to the next line, which must start with these words. Throws std::runtime_error if it does not.
SCREE_BODY void next_stl_line(TextReader& reader, std::string_view first, std::string_view second = "") {
  std::string const wanted = std::string(first) + (second.empty() ? "" : " ") + std::string(second);
  if (!reader.next()) reader.fail("the file ends where '" + wanted + "' is expected");
  if (!is_word(reader.word(0), first) ||
      (!second.empty() && (reader.words().size() < 2 || !is_word(reader.word(1), second))))
    reader.fail("'" + wanted + "' is expected, not '" + std::string(reader.word(0).substr(0, 40)) + "'");
}

SCREE_BODY Triangles read_ascii_stl(std::string_view text, std::string const& name) {
  Triangles result{.name = name, .numbered = "line"};
  TextReader reader(text, name);
  bool open = false;
  while (reader.next()) {
    if (is_word(reader.word(0), open ? "endsolid" : "solid")) {
      open = !open;
      continue;
    }
    if (!open || !is_word(reader.word(0), "facet"))
      reader.fail(std::string(open ? "'facet' or 'endsolid'" : "'solid'") + " is expected, not '" +
                  std::string(reader.word(0).substr(0, 40)) + "'");
    int const first = int(result.vertices.size());
    check_vertices(name, first + 3.0);
    result.numbers.push_back(reader.line());
    next_stl_line(reader, "outer", "loop");
    for (int corner = 0; corner < 3; ++corner) {
      next_stl_line(reader, "vertex");
      reader.demand(reader.words().size() == 4, "a vertex has three coordinates");
      result.vertices.push_back({reader.number(1), reader.number(2), reader.number(3)});
    }
    next_stl_line(reader, "endloop");
    next_stl_line(reader, "endfacet");
    result.corners.push_back({first, first + 1, first + 2});
  }
  if (open) reader.fail("the file ends within a solid: 'endsolid' is missing");
  return result;
}

}  // namespace detail

SCREE_BODY Triangles read_stl(std::string_view bytes, std::string const& name) {
  bool const has_head = bytes.size() >= detail::stl_head;
  if (has_head && bytes.size() == detail::binary_stl_size(bytes)) return detail::read_binary_stl(bytes, name);
  std::size_t const first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  bool const is_text = bytes.find('\0') == bytes.npos;
  if (is_text && detail::is_word(bytes.substr(first, 5), "solid")) return detail::read_ascii_stl(bytes, name);
  if (!has_head)
    throw std::runtime_error(name + ": " + std::to_string(bytes.size()) + " bytes are no STL file: it starts with " +
                             "'solid' or has a head of 84 bytes");
  std::size_t const named = (detail::binary_stl_size(bytes) - detail::stl_head) / detail::stl_triangle;
  throw std::runtime_error(
      name + ": it names " + std::to_string(named) + " triangles, for which a binary STL file has " +
      std::to_string(detail::binary_stl_size(bytes)) + " bytes, but it has " + std::to_string(bytes.size()));
}

}  // namespace scree
