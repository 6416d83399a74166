// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace scree {

/// Whether `time` is reached at the time `now`, apart from rounding errors.
inline bool has_come(double time, double now) { return time <= now * (1 + 1e-12); }

/// An action at given times.
template <class S>
struct Observer {
  std::function<double(double now)> next;  ///< returns the time of the first action after `now`, s
  std::function<void(S&)> act;             ///< the action
};

namespace detail {
template <class Act, class S>
concept Observes = !std::is_void_v<S> && std::is_convertible_v<Act, std::function<void(S&)>>;
/// A placeholder for an observer after a compile-time error.
template <class S>
struct any_observer {
  using type = Observer<S>;
};
template <>
struct any_observer<void> {
  struct type {
    template <class S>
    operator Observer<S>() const;
  };
};
template <class S>
using refused_observer = typename any_observer<S>::type;
/// Throws std::invalid_argument if an observer lacks one of its functions.
[[gnu::cold]] inline void check_has_functions(bool has_them) {
  if (!has_them) throw std::invalid_argument("scree: an observer needs functions `next` and `act`, and one is empty");
}
template <class X, class S>
constexpr void explain_observers() {
  static_assert(sizeof(X) == 0,
                "the observers of a run are a list in braces of what every<S>() and at<S>() return for this solver S: "
                "run(end, {every<S>(interval, [&](S& now) { ... })})");
}
}  // namespace detail

/// Returns an observer that acts at 0, interval, 2 interval, ... (s). Throws std::invalid_argument if the interval is
/// not positive or the action is empty.
template <class S>
Observer<S> every(double interval, std::function<void(S&)> act) {
  check_setting(interval > 0, "the interval of every() (s)", interval, "above 0");
  detail::check_has_functions(bool(act));
  return {[interval](double now) { return interval * std::floor(now / interval * (1 + 1e-12) + 1); }, std::move(act)};
}
/// Returns an observer that acts at given times (s). Throws std::invalid_argument if a time is negative or NaN, or if
/// the action is empty.
template <class S>
Observer<S> at(std::vector<double> times, std::function<void(S&)> act) {
  for (double const time : times) check_setting(time >= 0, "a time of at() (s)", time, "0 or more");
  detail::check_has_functions(bool(act));
  std::sort(times.begin(), times.end());
  return {[times](double now) {
            auto const next =
                std::partition_point(times.begin(), times.end(), [now](double time) { return has_come(time, now); });
            return next == times.end() ? std::numeric_limits<double>::infinity() : *next;
          },
          std::move(act)};
}

// Overloads for all other arguments, which report at compile time what is wrong with the observer.
template <class S = void, class Interval, class Act>
requires(!detail::Observes<Act, S> ||
         !std::is_convertible_v<Interval, double>) detail::refused_observer<S> every(Interval const&, Act const&) {
  static_assert(!std::is_void_v<S>, "name the solver that is observed: every<S>(interval, action)");
  static_assert(std::is_void_v<S> || std::is_convertible_v<Interval, double>,
                "every() takes an interval, a number in s; at() takes a list of times");
  static_assert(std::is_void_v<S> || detail::Observes<Act, S>,
                "the action of an observer is a function of the solver: every<S>(interval, [&](S& now) { ... })");
  return {};
}
template <class S = void, class Times, class Act>
requires(!detail::Observes<Act, S> ||
         !std::is_convertible_v<Times, std::vector<double>>) detail::refused_observer<S> at(Times const&, Act const&) {
  static_assert(!std::is_void_v<S>, "name the solver that is observed: at<S>({time}, action)");
  static_assert(std::is_void_v<S> || std::is_convertible_v<Times, std::vector<double>>,
                "at() takes a list of times in s, also of one: at<S>({0.1}, action)");
  static_assert(std::is_void_v<S> || detail::Observes<Act, S>,
                "the action of an observer is a function of the solver: at<S>({time}, [&](S& now) { ... })");
  return {};
}

/// The next times of the observers of a run. Times that differ only by rounding (3 * 0.1 s and 0.3 s) are treated as
/// equal.
template <class S>
class Schedule {
 public:
  /// Runs all observers if the time of the solver is 0. The observers must outlive the schedule. Throws
  /// std::invalid_argument if an observer lacks a function or returns a next time that is not later than the current
  /// time.
  Schedule(std::vector<Observer<S>> const& observers, S& solver) : observers_(observers) {
    for (auto const& observer : observers_) detail::check_has_functions(observer.next && observer.act);
    for (auto const& observer : observers_) {
      if (solver.time() == 0) observer.act(solver);
      due_.push_back(next_of(observer, solver.time()));
    }
  }
  /// Returns the next time to reach (s): the earliest next time of the observers, or `until` if that is earlier.
  double next(double until) const {
    double const first = due_.empty() ? until : *std::min_element(due_.begin(), due_.end());
    return has_come(until, first) ? until : first;
  }
  /// Runs all observers whose next time is reached.
  void act(S& solver) {
    for (std::size_t k = 0; k < due_.size(); ++k) {
      if (!has_come(due_[k], solver.time())) continue;
      observers_[k].act(solver);
      due_[k] = next_of(observers_[k], std::max(due_[k], solver.time()));
    }
  }

 private:
  static double next_of(Observer<S> const& observer, double now) {
    double const next = observer.next(now);
    check_setting(next > now, "the next time of an observer (s)", next, "later than the present one");
    return next;
  }

  std::vector<Observer<S>> const& observers_;
  std::vector<double> due_;
};

}  // namespace scree
