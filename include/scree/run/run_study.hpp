// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/instances.hpp"
#include "interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <ranges>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

// Many small runs in one process, several of them at a time.
namespace scree {

/// The outcome of a case of a study: a result, or an exception. With neither it was not begun, because the study was
/// stopped before.
template <class Result>
struct CaseEnd {
  std::optional<Result> result = {};  ///< empty if the case failed or did not begin
  std::exception_ptr failure = {};    ///< the exception that ended the case

  /// Whether the case was run: it then has a result or a failure.
  bool begun() const { return result || failure; }
};

/// The number of workers that keeps a device busy with small cases: on a host one for each thread; eight on a GPU,
/// where the launches of more host threads take turns (docs/performance.md), but no more than the host has cores,
/// because a thread that waits for a GPU keeps one busy. At most one per case.
template <class Space>
int workers_for(std::size_t cases) {
  int const cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  int const busy = on_host<Space> ? Space().concurrency() : std::min(8, cores);
  return static_cast<int>(std::clamp<std::size_t>(cases, 1, std::size_t(std::max(busy, 1))));
}

namespace detail {

template <class Space, class Cases>
struct StudyOf {
  using Case = std::ranges::range_reference_t<Cases const>;
  static constexpr bool takes_space = std::is_invocable_v<Case, Space const&>;
  static_assert(takes_space,
                "a case of a study is called with an execution-space instance: [](Space const& space) { ... }");
  using Result =
      typename std::conditional_t<takes_space, std::invoke_result<Case, Space const&>, std::type_identity<int>>::type;
  static constexpr bool has_result = !std::is_void_v<Result>;
  static_assert(has_result, "a case of a study returns its result, for instance a row of numbers");
  static constexpr bool is_right = takes_space && has_result;
  using End = CaseEnd<std::conditional_t<has_result, std::decay_t<Result>, int>>;
};

/// Calls work(instance) in a thread for each instance, or in this one if it is the only one.
template <class Space, class Work>
void work_on(std::vector<Space> const& instances, Work const& work) {
  if (instances.size() == 1) return work(instances.front());
  std::vector<std::jthread> threads;
  for (Space const& instance : instances) threads.emplace_back([&work, &instance] { work(instance); });
}

}  // namespace detail

/// Runs a list of cases, functions of an execution-space instance that return a result, in `workers` host threads
/// (0: workers_for()), each with an instance of its own. A worker takes the next case when it is done with one. Cases
/// begin in their order; the results are in it, too, whichever ends first. A solver on its instance gives the bits that
/// it gives alone, so results do not depend on the number of workers. Returns the ends of all cases. Throws
/// std::invalid_argument for a negative number of workers.
///
/// An exception ends its case and is stored in the result of that case; the others continue. `ended(number, end)`, if
/// given, is called after each case, by one thread at a time; its exception is rethrown here when the running cases
/// have ended. After a signal (see Interrupt) no further case begins; those under way see the same signal, and their
/// Checkpoints leave a checkpoint and end them.
///
///     std::vector<std::function<double(Space const&)>> cases;
///     for (double const speed : {1.0, 2.0, 4.0})
///       cases.push_back([=](Space const& space) {
///         Solver<F> solver(space, settings_of(speed), points);
///         solver.run(1);
///         return mixed(solver);
///       });
///     for (auto const& end : run_study<Space>(cases)) ...
template <class Space, std::ranges::random_access_range Cases, class Of = detail::StudyOf<Space, Cases>>
std::vector<typename Of::End> run_study(
    Cases const& cases, int workers = 0,
    std::type_identity_t<std::function<void(std::size_t, typename Of::End const&)>> const& ended = {}) {
  check_setting(workers >= 0, "the number of workers", workers, "0 or more");
  std::size_t const count = std::ranges::size(cases);
  std::vector<typename Of::End> ends(count);
  Interrupt const interrupt;
  std::atomic<std::size_t> next = 0;
  std::mutex one_at_a_time;
  std::exception_ptr of_caller;
  auto const tell = [&](std::size_t k) {
    std::scoped_lock const lock(one_at_a_time);
    try {
      if (ended) ended(k, ends[k]);
    } catch (...) {
      if (!of_caller) of_caller = std::current_exception();
      next = count;
    }
  };
  auto const work = [&](Space const& instance) {
    while (!interrupt.requested()) {
      std::size_t const k = next++;
      if (k >= count) return;
      try {
        if constexpr (Of::is_right)
          ends[k].result.emplace(std::ranges::begin(cases)[std::ranges::range_difference_t<Cases const>(k)](instance));
      } catch (...) {
        ends[k].failure = std::current_exception();
      }
      tell(k);
    }
  };
  if (workers == 0) workers = workers_for<Space>(count);
  detail::work_on(instances_of<Space>(static_cast<int>(std::clamp<std::size_t>(count, 1, std::size_t(workers)))), work);
  if (of_caller) std::rethrow_exception(of_caller);
  return ends;
}

}  // namespace scree
