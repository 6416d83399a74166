// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "rings.hpp"

#include <deque>
#include <stdexcept>

// The states that a profile averages, also as numbers for a checkpoint.
namespace drum {

/// The sums over one state.
struct Sample {
  double time = 0;  ///< s
  MidChord chord;
  Rings rings;

  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor(time), chord.visit(visitor), rings.visit(visitor);
  }
};
using Window = std::deque<Sample>;

namespace detail {

struct Pack {
  std::vector<double> numbers = {};
  void operator()(double value) { numbers.push_back(value); }
  template <class List>
  void size(List const& list) {
    numbers.push_back(static_cast<double>(list.size()));
  }
};
struct Unpack {
  std::span<double const> numbers;
  void operator()(double& value) {
    if (numbers.empty()) throw std::runtime_error("the checkpoint does not hold all of the states of a profile");
    value = numbers.front(), numbers = numbers.subspan(1);
  }
  template <class List>
  void size(List& list) {
    double count = 0;
    operator()(count);
    if (!(count >= 0 && count <= static_cast<double>(numbers.size())))
      throw std::runtime_error("the checkpoint does not hold the states of a profile");
    list.resize(static_cast<std::size_t>(count));
  }
};

}  // namespace detail

inline std::vector<double> pack(Window window) {
  detail::Pack pack;
  for (Sample& sample : window) sample.visit(pack);
  return pack.numbers;
}
/// Throws std::runtime_error for numbers that pack() cannot have written.
inline Window unpack(std::span<double const> numbers) {
  Window window;
  for (detail::Unpack unpack{numbers}; !unpack.numbers.empty();) window.emplace_back().visit(unpack);
  return window;
}

}  // namespace drum
