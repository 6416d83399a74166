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

// Many small runs in one process, several at a time.
namespace scree {

/// The outcome of a case of a study: a result or an exception. If it has neither, the case did not begin, because the
/// study was stopped earlier.
template <class Result>
struct CaseEnd {
  std::optional<Result> result = {};  ///< empty if the case failed or did not begin
  std::exception_ptr failure = {};    ///< the exception that ended the case

  /// Whether the case has begun, so that it has a result or a failure.
  bool begun() const { return result || failure; }
};

/// Returns the number of workers that keeps a device busy with small cases, at most one per case. On a host, this is
/// one worker per thread. On a GPU it is eight, because the kernel launches of more host threads are serialised
/// (docs/performance.md), but no more than the host has cores, because a thread that waits for a GPU occupies a core.
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

/// Calls work(instance) in a new thread for each instance, or in the calling thread if there is only one instance.
template <class Space, class Work>
void work_on(std::vector<Space> const& instances, Work const& work) {
  if (instances.size() == 1) return work(instances.front());
  std::vector<std::jthread> threads;
  for (Space const& instance : instances) threads.emplace_back([&work, &instance] { work(instance); });
}

}  // namespace detail

/// Runs a list of cases in `workers` host threads (0: workers_for()), each with its own instance of the execution
/// space, and returns the outcomes of all cases. A case is a function of an instance that returns a result. A worker
/// that has finished a case takes the next one. Cases begin in the order of the list, and the outcomes are in the same
/// order, whichever case ends first. A solver gives the same bits as if it ran alone, so results do not depend on the
/// number of workers. Throws std::invalid_argument for a negative number of workers.
///
/// An exception ends its case and is stored in the outcome of that case; the other cases continue. If `ended` is given,
/// ended(number, end) is called after each case, by one thread at a time. If it throws, no further case begins, and the
/// exception is rethrown when the running cases have ended. After a signal (see Interrupt), no further case begins; the
/// running cases receive the same signal, and their Checkpoints write a checkpoint and end them.
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
