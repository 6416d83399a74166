// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../fields/columns.hpp"
#include "../fields/record.hpp"
#include "../fields/standard.hpp"
#include "pair.hpp"

#include <type_traits>

// The pairs of a target on a CPU: those within the support are collected, and the terms work on as many at once as the
// processor has lanes.
namespace scree::detail {

/// A basis whose numbers are packs.
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

/// Values of a field in packs, value_in(k) in lane k. Of an integer there is but one for all lanes.
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
SCREE_LOOP_FN auto sum_of_lanes(Eigen::Matrix<Pack<Real, Size>, Rows, Cols, Eigen::DontAlign> const& values,
                                int lanes) {
  Eigen::Matrix<Real, Rows, Cols, Eigen::DontAlign> sum;
  for (int k = 0; k < Rows * Cols; ++k) sum.data()[k] = values.data()[k].sum(lanes);
  return sum;
}

/// Pairs of one target with the particles of a source. Sums depend on which pairs there are and on their order, not on
/// the candidates among which they were found.
template <class P, class Source, class I>
class PairsInPacks {
  using Lanes = Pack<typename P::real>;
  using Totals = Sums<Packed<P>, typename Source::adds>;

 public:
  /// itself: the index of the target among the sources, or negative; the pair with itself is left out.
  SCREE_LOOP_FN PairsInPacks(Source const& source, I const& self, int itself, kernel_of<P> const& kernel)
      : source_(source),
        place_(self[position]),
        itself_(itself),
        squared_radius_(sq(kernel.radius())),
        self_(repeated(self, typename Source::reads_i{})),
        kernel_(kernel) {}

  /// A candidate.
  SCREE_LOOP_FN void add(int j) {
    found_[count_] = j;
    // A distance that is not a number must show in the sums.
    bool const beyond = (place_ - source_.particles.load(position, j)).squaredNorm() >= squared_radius_;
    count_ += beyond || j == itself_ ? 0 : 1;
    if (count_ == room) sum_full_packs();
  }
  /// Adds what has been summed over all pairs.
  template <class S>
  SCREE_LOOP_FN void finish(S& sums) {
    sum_full_packs();
    add_to(sums, totals_, Lanes::size, typename Source::adds{});
    if (count_ == 0) return;
    for (int k = count_; k < Lanes::size; ++k) found_[k] = found_[0];
    Totals last;
    visit(0, last);
    add_to(sums, last, count_, typename Source::adds{});
  }

 private:
  static constexpr int room = 32;
  static_assert(room % Lanes::size == 0);

  template <class... Fs>
  SCREE_LOOP_FN static Record<Packed<P>, Fields<Fs...>> repeated(I const& i, Fields<Fs...>) {
    return {{in_lanes<P>(
        Fs{}, [&](int) -> auto const& { return i[Fs{}]; })}...};
  }
  template <class... Fs>
  SCREE_LOOP_FN Record<Packed<P>, Fields<Fs...>> gathered(int const* j, Fields<Fs...>) const {
    return {{in_lanes<P>(
        Fs{}, [&](int lane) -> auto const& { return source_.particles[Fs{}](j[lane]); })}...};
  }
  SCREE_LOOP_FN void sum_full_packs() {
    int k = 0;
    for (; k + Lanes::size <= count_; k += Lanes::size) visit(k, totals_);
    count_ -= k;
    for (int rest = 0; rest < count_; ++rest) found_[rest] = found_[k + rest];
  }
  SCREE_LOOP_FN void visit(int k, Totals& sums) const {
    auto const others = gathered(found_ + k, typename Source::stored{});
    Vec<P::dim, Lanes> const x = self_[position] - others[position];
    Pair<Packed<P>> const ij(x, root(x.squaredNorm()), kernel_);
    source_.apply_all(self_, others, ij, sums);
  }
  template <class S, class... Fs>
  SCREE_LOOP_FN static void add_to(S& sums, Totals const& totals, int lanes, Fields<Fs...>) {
    auto const in_packs = totals.totals();
    ((sums[Fs{}] += sum_of_lanes(in_packs[Fs{}], lanes)), ...);
  }

  Source const& source_;
  Vec<P::dim, typename P::real> place_;
  int itself_, count_ = 0;
  typename P::real squared_radius_;
  Record<Packed<P>, typename Source::reads_i> self_;
  kernel_of<Packed<P>> kernel_;
  Totals totals_;
  int found_[room];
};

/// Passes candidates on, for a search calls what it is given as a constant.
template <class Pairs>
struct AddPair {
  Pairs& pairs;
  SCREE_LOOP_FN void operator()(int j) const { pairs.add(j); }
};

}  // namespace scree::detail
