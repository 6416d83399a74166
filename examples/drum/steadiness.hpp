// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "moment.hpp"

// Steadiness of a run: means and spreads of its history.
namespace drum {

/// Spread of one quantity over a span of time, from means over blocks of one second, which average out the noise of
/// particles that pass the surface one by one. NaN without a whole block.
struct Spread {
  double mean = detail::missing(), least = detail::missing(), largest = detail::missing();
  double slope = detail::missing();  ///< per s, of the straight line through the blocks
};

namespace detail {

struct Block {
  double time, mean;
};
inline std::vector<Block> blocks(std::vector<Moment> const& history, double Moment::*quantity, double from) {
  std::map<long, std::pair<Mean, Mean>> seconds;  // time, value
  for (auto const& m : history) {
    if (m.time < from || std::isnan(m.*quantity)) continue;
    auto& [time, value] = seconds[std::lround(std::floor(m.time - from))];
    time.add(m.time), value.add(m.*quantity);
  }
  std::vector<Block> result;
  for (auto const& [second, means] : seconds)
    if (history.back().time >= from + double(second) + 1 - 1e-6)
      result.push_back({means.first.value(), means.second.value()});
  return result;
}

}  // namespace detail

inline Spread spread(std::vector<Moment> const& history, double Moment::*quantity, double from) {
  Spread s;
  if (history.empty()) return s;
  auto const found = detail::blocks(history, quantity, from);
  Mean time, value;
  for (auto const& b : found) time.add(b.time), value.add(b.mean);
  s.mean = value.value(), s.least = value.lowest(), s.largest = value.highest();
  double tt = 0, tv = 0;
  for (auto const& b : found) {
    tt += (b.time - time.value()) * (b.time - time.value());
    tv += (b.time - time.value()) * (b.mean - value.value());
  }
  s.slope = tv / tt;
  return s;
}

}  // namespace drum
