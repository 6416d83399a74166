// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace scree {

/// Something to be done at given times.
template <class S>
struct Observer {
  std::function<double(double now)> next;  // next time after `now`, s
  std::function<void(S&)> act;
};

/// An observer that acts at 0, interval, 2 interval, ... (s). Throws std::invalid_argument unless that is positive.
template <class S>
Observer<S> every(double interval, std::function<void(S&)> act) {
  check_setting(interval > 0, "the interval of every() (s)", interval, "above 0");
  return {[interval](double now) { return interval * std::floor(now / interval * (1 + 1e-12) + 1); }, std::move(act)};
}
/// An observer that acts at given times (s).
template <class S>
Observer<S> at(std::vector<double> times, std::function<void(S&)> act) {
  std::sort(times.begin(), times.end());
  return {[times](double now) {
            auto const next = std::upper_bound(times.begin(), times.end(), now);
            return next == times.end() ? std::numeric_limits<double>::infinity() : *next;
          },
          std::move(act)};
}

}  // namespace scree
