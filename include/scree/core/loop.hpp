// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "space.hpp"
#include "span.hpp"
#include "types.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// Parallel loops over indices on a given instance of an execution space. On a GPU, they are Kokkos loops. On a host, a
// single Kokkos loop runs over portions of the range, one per thread, and calls the loop body through a pointer. This
// single loop is compiled only once; a Kokkos loop takes ten times as long to compile as the function inside it.
namespace scree {
namespace detail {

/// A type-erased function that is called for portions of a range of indices.
class Portions {
 public:
  template <class Function>
  Portions(Function const& function, int first, int last, int count)
      : run_([](void const* f, int portion, int from, int to) {
          (*static_cast<Function const*>(f))(portion, from, to);
        }),
        function_(&function),
        first_(first),
        last_(last),
        count_(count) {}

  void operator()(int portion) const { run_(function_, portion, begin(portion), begin(portion + 1)); }

 private:
  int begin(int portion) const {
    return first_ + static_cast<int>(std::int64_t(last_ - first_) * portion / std::max(count_, 1));
  }
  void (*run_)(void const* function, int portion, int from, int to);
  void const* function_;
  int first_, last_, count_;
};

template <class Space>
int portions_of(Space const& space, int indices) {
  return std::clamp(space.concurrency(), 0, std::max(indices, 0));
}

/// Runs all portions and waits until they have finished.
template <class Space>
void run_portions(Space const& space, std::string_view label, int count, Portions const& portions) {
  std::string const name(label);
  Kokkos::parallel_for(name, Kokkos::RangePolicy<Space>(space, 0, count), portions);
  space.fence(name);  // the caller owns the function; OpenMP itself does not wait
}

/// Calls function(portion, from, to) for each of `count` portions of [first, last).
template <class Space, class Function>
void for_each_portion(Space const& space, std::string_view label, int first, int last, int count,
                      Function const& function) {
  run_portions(space, label, count, Portions(function, first, last, count));
}

/// Untyped memory for one value per portion. With it, reduce() compiles faster than with a std::vector of each value
/// type.
class ValuesOfPortions {
 public:
  ValuesOfPortions(int count, std::size_t bytes_of_each)
      : words_((static_cast<std::size_t>(count) * bytes_of_each + sizeof(Word) - 1) / sizeof(Word)),
        each_(bytes_of_each) {}
  void* at(int portion) {
    return reinterpret_cast<std::byte*>(words_.data()) + static_cast<std::size_t>(portion) * each_;
  }

 private:
  struct Word {
    alignas(std::max_align_t) std::byte bytes[alignof(std::max_align_t)];
  };
  std::vector<Word> words_;
  std::size_t each_;
};

/// Whether a function has init() and join() with exactly these signatures; otherwise Kokkos would reduce by summation.
template <class Function, class Value = typename Function::value_type>
concept Reduction = requires {
  static_cast<void (Function::*)(Value&) const>(&Function::init);
  static_cast<void (Function::*)(Value&, Value const&) const>(&Function::join);
};

}  // namespace detail

/// Calls function(i) for each i in [first, last).
template <class Space, class Function>
void for_each_index(Space const& space, std::string_view label, int first, int last, Function const& function) {
  if constexpr (on_host<Space>)
    detail::for_each_portion(space, label, first, last, detail::portions_of(space, last - first),
                             [&](int, int from, int to) {
                               for (int i = from; i < to; ++i) function(i);
                             });
  else
    Kokkos::parallel_for(std::string(label), Kokkos::RangePolicy<Space>(space, first, last), function);
}

/// Returns the reduction of function(i, value) over all i in [0, count). function.init(value) initialises a value of
/// type Function::value_type, and function.join(value, other) merges `other` into `value`.
template <class Space, detail::Reduction Function>
typename Function::value_type reduce(Space const& space, std::string_view label, int count, Function const& function) {
  using Value = typename Function::value_type;
  Value result;
  if constexpr (on_host<Space>) {
    static_assert(std::is_trivially_destructible_v<Value> && alignof(Value) <= alignof(std::max_align_t));
    int const portions = detail::portions_of(space, count);
    detail::ValuesOfPortions values(portions, sizeof(Value));
    detail::for_each_portion(space, label, 0, count, portions, [&](int portion, int from, int to) {
      Value here;
      function.init(here);
      for (int i = from; i < to; ++i) function(i, here);
      new (values.at(portion)) Value(here);
    });
    function.init(result);
    for (int portion = 0; portion < portions; ++portion)
      function.join(result, *std::launder(static_cast<Value const*>(values.at(portion))));
  } else {
    Kokkos::parallel_reduce(std::string(label), Kokkos::RangePolicy<Space>(space, 0, count), function, result);
  }
  return result;
}

namespace detail {

/// A function for reduce() that finds the largest of some integers, or 0 if none is positive.
struct LargestValue {
  using value_type = int;
  Span<int const> values;
  SCREE_FN void init(int& largest) const { largest = 0; }
  SCREE_FN void join(int& largest, int const& other) const { largest = Kokkos::max(largest, other); }
  SCREE_FN void operator()(int k, int& largest) const { largest = Kokkos::max(largest, values(k)); }
};
/// A kernel in which one team of threads per range sums function(i) over the indices of the range.
template <class Function>
struct SumOfRange {
  Function function;
  Span<int const> bounds;
  template <class Team>
  SCREE_FN void operator()(Team const& team) const {
    int const range = team.league_rank();
    typename Function::value_type sum;
    Kokkos::parallel_reduce(
        Kokkos::TeamThreadRange(team, bounds(range), bounds(range + 1)),
        [&](int i, typename Function::value_type& part) { part += function(i); }, sum);
    if (team.team_rank() == 0) function.store(range, sum);
  }
};
}  // namespace detail

/// Calls function.store(range, sum) for each range [bounds(range), bounds(range + 1)) of indices, with the sum of
/// function(i) over the range. All ranges need only one kernel launch, and repeated calls sum in the same order. A
/// default-constructed Function::value_type must be zero, and += must add; on a GPU, Kokkos::reduction_identity must
/// give zero as well.
template <class Space, class Function>
void sum_ranges(Space const& space, std::string_view label, Span<int const> bounds, Function const& function) {
  int const ranges = bounds.size() - 1;
  if constexpr (on_host<Space>) {
    for_each_index(space, label, 0, ranges, [&](int range) {
      typename Function::value_type sum;
      for (int i = bounds(range); i < bounds(range + 1); ++i) sum += function(i);
      function.store(range, sum);
    });
  } else {
    constexpr int threads = 512;
    Kokkos::parallel_for(std::string(label), Kokkos::TeamPolicy<Space>(space, ranges, threads),
                         detail::SumOfRange<Function>{function, bounds});
  }
}

/// Calls function(i, sum, last) for all i in [0, count). `sum` is the sum over all preceding indices, to which the
/// function adds the contribution of i; `sum` is final only if `last` is true. Returns the total.
template <class Space, class Function>
int running_sum(Space const& space, std::string_view label, int count, Function const& function) {
  int total = 0;
  if constexpr (on_host<Space>) {
    std::vector<int> sums(static_cast<std::size_t>(detail::portions_of(space, count)), 0);
    auto const sum_up = [&](bool last) {
      detail::for_each_portion(space, label, 0, count, static_cast<int>(sums.size()),
                               [&](int portion, int from, int to) {
                                 int sum = sums[static_cast<std::size_t>(portion)];
                                 for (int i = from; i < to; ++i) function(i, sum, last);
                                 sums[static_cast<std::size_t>(portion)] = sum;
                               });
    };
    if (sums.size() > 1) {
      sum_up(false);
      for (int& sum : sums) total += std::exchange(sum, total);
    }
    sum_up(true);
    total = sums.empty() ? 0 : sums.back();
  } else {
    Kokkos::parallel_scan(std::string(label), Kokkos::RangePolicy<Space>(space, 0, count), function, total);
  }
  return total;
}

}  // namespace scree
