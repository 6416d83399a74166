// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../fields/columns.hpp"
#include "../fields/record.hpp"
#include "../fields/standard.hpp"
#include "../neighbours/lanes.hpp"
#include "pair.hpp"

#include <type_traits>

// The summation over the neighbours of a target on a CPU: the pairs within the support are collected, and the terms
// process one pack of pairs at a time, with one pair per lane.
namespace scree::detail {

/// The basis P with packs in place of its real numbers.
template <class P, class Lanes = Pack<typename P::real>>
struct Packed {
  static constexpr int dim = P::dim;
  using real = Lanes;
  using kernel = typename P::kernel;
};

template <class P, class List>
inline constexpr bool has_integers = false;
template <class P, class... Fs>
inline constexpr bool has_integers<P, Fields<Fs...>> = (std::is_integral_v<value_t<P, Fs>> || ...);

/// Returns the values of a field in packs, with value_in(k) in lane k. Integers are not vectorised: all lanes share the
/// integer of lane 0.
template <class P, class F, class ValueIn>
SCREE_LOOP_FN value_t<Packed<P>, F> in_lanes(F, ValueIn const& value_in) {
  using Value = value_t<P, F>;
  using Lanes = Pack<typename P::real>;
  if constexpr (std::is_same_v<Value, typename P::real>) {
    return Lanes::of(value_in);
  } else if constexpr (std::is_integral_v<Value>) {
    return value_in(0);
  } else {
    value_t<Packed<P>, F> values;
    for (int k = 0; k < Value::SizeAtCompileTime; ++k)
      values.data()[k] = Lanes::of([&](int lane) { return value_in(lane).data()[k]; });
    return values;
  }
}

template <class Real, int Size>
SCREE_LOOP_FN Real sum_of_lanes(Pack<Real, Size> const& values, int lanes) {
  return values.sum(lanes);
}
template <class Real, int Size, int Rows, int Cols>
SCREE_LOOP_FN auto sum_of_lanes(Small<Pack<Real, Size>, Rows, Cols> const& values, int lanes) {
  Small<Real, Rows, Cols> sum;
  for (int k = 0; k < Rows * Cols; ++k) sum.data()[k] = values.data()[k].sum(lanes);
  return sum;
}

/// The sum of one field of a target.
template <class P, class F>
struct SumAt {
  Sum<value_t<P, F>>& sum;
};
template <class P, class List>
struct SumsAmong;
template <class P, class... Fs>
struct SumsAmong<P, Fields<Fs...>> : SumAt<P, Fs>... {
  template <class S>
  SCREE_LOOP_FN explicit SumsAmong(S& sums) : SumAt<P, Fs>{sums[Fs{}]}... {}
  template <Field F>
  SCREE_LOOP_FN auto& operator[](F) const {
    return static_cast<SumAt<P, F> const&>(*this).sum;
  }
};

/// The sum of the terms over the pairs of one target with the particles of a source. The type depends neither on the
/// other sources of the loop nor on the function that takes the sums.
template <class P, class Source>
class SumInPacks {
  using Lanes = Pack<typename P::real>;
  using Self = Record<P, typename Source::reads_i>;
  using Added = SumsAmong<P, typename Source::adds>;
  using Totals = Sums<Packed<P>, typename Source::adds>;

 public:
  static constexpr int lanes = Lanes::size;

  template <class I, class S>
  SCREE_LOOP_FN SumInPacks(Source const& source, I const& self, kernel_of<P> const& kernel, S& sums)
      : source_(source), self_(part_of(self, typename Source::reads_i{})), kernel_(kernel), sums_(sums) {}

  /// Sums over the first `count` particles of j, which lie within the support. The array j must have room to fill the
  /// last pack.
  SCREE_LOOP_FN void operator()(int* j, int count) const {
    auto const i = repeated(typename Source::reads_i{});
    kernel_of<Packed<P>> const kernel(kernel_);
    Totals totals;
    int k = 0;
    for (; k + lanes <= count; k += lanes) visit(i, j + k, kernel, totals);
    add(totals, lanes, typename Source::adds{});
    if (k == count) return;
    for (int spare = count; spare % lanes != 0; ++spare) j[spare] = j[k];
    Totals last;
    visit(i, j + k, kernel, last);
    add(last, count - k, typename Source::adds{});
  }

 private:
  template <class I, class... Fs>
  SCREE_LOOP_FN static Self part_of(I const& self, Fields<Fs...>) {
    return {{self[Fs{}]}...};
  }
  template <class Packs>
  SCREE_LOOP_FN void visit(Packs const& i, int const* j, kernel_of<Packed<P>> const& kernel, Totals& totals) const {
    using namespace fields;
    using namespace math;
    auto const others = gathered(j, typename Source::stored{});
    Vec<P::dim, Lanes> const x = i[position] - others[position];
    Pair<Packed<P>> const ij(x, root(squared_norm(x)), kernel);
    source_.apply_all(i, others, ij, totals);
  }
  template <class... Fs>
  SCREE_LOOP_FN Record<Packed<P>, Fields<Fs...>> repeated(Fields<Fs...>) const {
    return {{in_lanes<P>(
        Fs{}, [&](int) -> auto const& { return self_[Fs{}]; })}...};
  }
  template <class... Fs>
  SCREE_LOOP_FN Record<Packed<P>, Fields<Fs...>> gathered(int const* j, Fields<Fs...>) const {
    return {{in_lanes<P>(
        Fs{}, [&](int lane) -> auto const& { return source_.particles[Fs{}](j[lane]); })}...};
  }
  /// Adds the first `count` lanes of the totals to the sums.
  template <class... Fs>
  SCREE_LOOP_FN void add(Totals const& totals, int count, Fields<Fs...>) const {
    auto const in_packs = totals.totals();
    ((sums_[Fs{}] += sum_of_lanes(in_packs[Fs{}], count)), ...);
  }

  Source const& source_;
  Self const self_;
  kernel_of<P> const& kernel_;
  Added const sums_;
};

/// Runs a summation in packs. Models with the same source share this function. Inlining is forced because, in a large
/// file, GCC would otherwise call the terms as functions, which costs more than packs save.
template <class P, class Source>
[[gnu::flatten, gnu::noinline]] void run_sum(SumInPacks<P, Source> const& sum, int* j, int count) {
  sum(j, count);
}
/// Whether the library scree::compiled contains run_sum() for a source, under the name run_compiled_sum().
template <class P, class Source>
inline constexpr bool is_compiled_sum = false;
template <class P, class Source>
void run_compiled_sum(SumInPacks<P, Source> const& sum, int* j, int count);

template <class P, class Source>
SCREE_LOOP_FN void run_in_packs(SumInPacks<P, Source> const& sum, int* j, int count) {
  if constexpr (is_compiled_sum<P, Source>)
    run_compiled_sum(sum, j, count);
  else
    run_sum(sum, j, count);
}

/// Sums the terms of a source over the pairs of one target. The sums depend on the pairs within the support and on
/// their order, not on the other candidates.
template <class P, class Source, class I, class S>
SCREE_LOOP_FN void sum_in_packs(Source const& source, int i, I const& self, kernel_of<P> const& kernel, LaneRange range,
                                S& sums) {
  using namespace fields;
  SumInPacks<P, Source> const sum(source, self, kernel, sums);
  constexpr int room = 128;  // more neighbours than most targets have
  static_assert(room % decltype(sum)::lanes == 0);
  int found[room], count = 0;
  auto const place = self[position];
  auto const squared_radius = sq(kernel.radius());
  int const itself = source.same_body ? i : -1;
  // The loop has no branch, which would be mispredicted close to the radius. A pair with a NaN distance is kept, so NaN
  // appears in the sums.
  auto const add = [&](int j) {
    found[count] = j;
    bool const beyond = squared_norm(place - source.particles.load(position, j)) >= squared_radius;
    count += int(!beyond) & int(j != itself);
    if (count == room) {
      run_in_packs(sum, found, count);
      count = 0;
    }
  };
  source.neighbours.for_each(i, place, add, range);
  if (count > 0) run_in_packs(sum, found, count);
}

}  // namespace scree::detail
