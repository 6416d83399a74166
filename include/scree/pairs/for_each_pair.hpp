// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "in_packs.hpp"
#include "term.hpp"

#include "../core/loop.hpp"
#include "../core/pass_label.hpp"
#include "../core/root.hpp"
#include "../fields/columns.hpp"
#include "../fields/standard.hpp"
#include "../neighbours/lanes.hpp"

#include <string>
#include <utility>

// The neighbour loop that all pair passes share. The loop accumulates the sums and the terms contain the physics;
// neither depends on the neighbour search, the execution space or the wall model.
namespace scree {
namespace detail {

/// Whether a lens gives the value of a field of particle j for particle i.
template <class Lens, class F, class I, class J>
concept ShowsField = requires(Lens const& lens, F field, I const& i, J const& j) {
  lens(field, i, j);
};

/// One body of neighbours with its columns, the view of a search, the lens for the values of j, and the terms to be
/// summed.
template <class P, class View, class Lens, class... Terms>
struct Source : Terms... {
  using reads = Merge<Fields<Position>, record_j<Terms>...>;
  using reads_i = Merge<Fields<Position>, record_i<Terms>..., reads_i_of<Lens>>;
  using adds = Merge<adds_of<Terms>...>;
  using stored = Merge<Without<reads, provides_of<Lens>>, reads_of<Lens>>;

  Columns<P, stored> particles;
  View neighbours;
  Lens lens;
  bool same_body;  // targets and neighbours are the same body, so j == i is the particle itself

  static constexpr bool in_packs = has_packs && runs_on_host<P> && takes_packs<typename P::kernel> &&
                                   takes_packs<Lens> && (takes_packs<Terms> && ...);

  static constexpr bool finds_first = !in_packs && (is_long<Terms> || ...);

  static_assert((!(takes_packs<Terms> && has_integers<P, record_j<Terms>>)&&...),
                "a term that takes packs reads an integer of j, which differs between the pairs of a pack");

  Source(Columns<P, stored> const& c, View const& v, Lens const& l, bool same, Terms const&... terms)
      : Terms(terms)..., particles(c), neighbours(v), lens(l), same_body(same) {}

  template <class I, class S>
  SCREE_LOOP_FN void add(int i, I const& self, kernel_of<P> const& kernel, LaneRange range, S& sums) const {
    if constexpr (in_packs) {
      sum_in_packs<P>(*this, i, self, kernel, range, sums);
      if (same_body) add_itself(i, self, kernel, sums);
    } else if constexpr (finds_first) {
      add_found(i, self, kernel, range, sums);
    } else {
      neighbours.for_each(i, self[fields::position], Visit<I, S>{*this, i, self, kernel, sums}, range);
    }
  }
  /// Adds the terms of one pack of pairs.
  template <class I, class J, class S>
  SCREE_LOOP_FN void apply_all(I const& i, J const& j, Pair<Packed<P>> const& ij, S& sums) const {
    auto const other = seen<Packed<P>>(i, j, reads{});
    (static_cast<Terms const&>(*this)(i, other, ij, sums), ...);
  }

 private:
  template <class Q, class I, class J, class F>
  SCREE_LOOP_FN static value_t<Q, F> see(Lens const& lens, I const& i, J const& j, F field) {
    constexpr bool provided = OneOf<F, provides_of<Lens>>, gives = ShowsField<Lens, F, I, J>;
    static_assert(gives || !provided,
                  "this lens names a field in `provides` for which it has no operator()(field, i, j) const");
    constexpr bool unlisted = gives && !provided && !ShowsField<Lens, AnyField, I, J>;
    static_assert(!unlisted, "this lens has an operator() for a field that is missing in its list `provides`");
    if constexpr (gives && provided)
      return lens(field, i, j);
    else if constexpr (provided)
      return missing<value_t<Q, F>>();
    else
      return j[field];
  }
  template <class Q, class I, class J, class... Fs>
  SCREE_LOOP_FN Record<Q, Fields<Fs...>> seen(I const& i, J const& j, Fields<Fs...>) const {
    return {{see<Q>(lens, i, j, Fs{})}...};
  }
  template <class Term, class I, class J, class S>
  SCREE_LOOP_FN void apply(bool itself, I const& i, J const& j, Pair<P> const& ij, S& sums) const {
    if constexpr (includes_self<Term>)
      static_cast<Term const&> (*this)(i, j, ij, sums);
    else if (!itself)
      static_cast<Term const&> (*this)(i, j, ij, sums);
  }
  /// Adds the pair of a particle with itself after all other pairs if pairs are summed in packs. Without packs, the
  /// neighbour loop visits this pair, which is faster on a GPU (docs/performance.md).
  template <class I, class S>
  SCREE_LOOP_FN void add_itself(int i, I const& self, kernel_of<P> const& kernel, S& sums) const {
    using namespace fields;
    if constexpr ((includes_self<Terms> || ...)) {
      auto const other = seen<P>(self, particles.load(i), reads{});
      Vec<P::dim, typename P::real> const x = self[position] - self[position];  // zero or NaN
      Pair<P> const ij(x, norm(x), kernel);
      (apply<Terms>(true, self, other, ij, sums), ...);
    }
  }

  /// Finds the particles within the support first and visits them afterwards, so that lanes which reject a candidate do
  /// not wait for lanes which accept one. The order of summation does not change.
  template <class I, class S>
  SCREE_LOOP_FN void add_found(int i, I const& self, kernel_of<P> const& kernel, LaneRange range, S& sums) const {
    using namespace fields;
    constexpr int room = 64;  // more than a lane usually finds; if a lane finds more, the search is repeated
    int found[room], done = 0, all = 0;
    auto const place = self[position];
    auto const squared_radius = sq(kernel.radius());
    do {
      int count = 0;
      all = 0;
      auto const take = [&](int j) {
        if (squared_norm(place - particles.load(position, j)) >= squared_radius) return;
        if (all >= done && count < room) found[count++] = j;
        ++all;
      };
      neighbours.for_each(i, place, take, range);
      for (int k = 0; k < count; ++k) visit(i, self, found[k], kernel, sums);
      done += count;
    } while (done < all);
  }

  template <class I, class S>
  struct Visit {
    Source const& source;
    int i;
    I const& self;
    kernel_of<P> const& kernel;
    S& sums;
    SCREE_LOOP_FN void operator()(int j) const { source.visit(i, self, j, kernel, sums); }
  };
  template <class I, class S>
  SCREE_LOOP_FN void visit(int i, I const& self, int j, kernel_of<P> const& kernel, S& sums) const {
    using namespace fields;
    using namespace math;
    using real = typename P::real;
    bool const itself = same_body && j == i;
    if constexpr (!(includes_self<Terms> || ...))
      if (itself) return;
    Record<P, Fields<Position>> const place{{particles.load(position, j)}};
    Vec<P::dim, real> const x = self[position] - place[position];
    real const squared = squared_norm(x);
    if (squared >= sq(kernel.radius())) return;
    auto const other = seen<P>(self, particles.load(j, place), reads{});
    // The root follows the loads because a GPU computes it while it waits for the data.
    Pair<P> const ij(x, root(squared), kernel);
    (apply<Terms>(itself, self, other, ij, sums), ...);
  }
};

/// The K-th source of a loop. The source is a member and not a base class, because nvcc 13 misaligns a base class whose
/// own first base is a term of one byte: it places the source right after the last byte of the preceding one. The host
/// compiler does not, so the device would read values other than those passed by the host.
template <std::size_t K, class S>
struct Indexed {
  S source;
};

/// A Kokkos reducer that adds up the sums of the lanes of a thread.
template <class P, class Adds>
class AddTotals {
 public:
  using reducer = AddTotals;
  using value_type = Record<P, Adds>;
  using result_view_type = Kokkos::View<value_type, Kokkos::AnonymousSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  SCREE_FN explicit AddTotals(value_type& result) : result_(result) {}
  SCREE_FN void init(value_type& total) const { total = Sums<P, Adds>().totals(); }
  SCREE_FN void join(value_type& total, value_type const& part) const { total += part; }
  SCREE_FN value_type& reference() const { return result_; }
  SCREE_FN result_view_type view() const { return result_view_type(&result_); }
  SCREE_FN bool references_scalar() const { return true; }

 private:
  value_type& result_;
};

template <class P, class Then, class Adds>
using stored_by = std::conditional_t<stores_sums<Then>, Adds, writes_of<Then>>;

template <class P, class Reads, class Adds, class Where, class Then, class Index, class... Sources>
struct PairLoop;
template <class P, class ReadFields, class Adds, class Where, class Then, std::size_t... K, class... Sources>
struct PairLoop<P, ReadFields, Adds, Where, Then, std::index_sequence<K...>, Sources...> : Indexed<K, Sources>... {
  using Reads = ReadFields;
  using Stored = stored_by<P, Then, Adds>;
  using Total = Record<P, Adds>;
  Columns<P, Reads> reads;
  Columns<P, Stored> stored;
  kernel_of<P> kernel;
  Where where;
  Then then;

  int targets, lanes;

  PairLoop(Columns<P, Reads> const& r, Columns<P, Stored> const& s, kernel_of<P> const& k, Where const& w,
           Then const& t, int n, long everywhere, Sources const&... sources)
      : Indexed<K, Sources>{sources}...,
        reads(r),
        stored(s),
        kernel(k),
        where(w),
        then(t),
        targets(n),
        lanes(lanes_for<P>(everywhere)) {}

  /// Sums over the neighbours of target `i` with one thread.
  SCREE_FN void operator()(int i) const {
    auto const self = reads.load(i);
    finish(i, self, sum(i, self, {}));
  }
  /// Sums over the neighbours of a target with the vector lanes of a thread, each of which takes a share of the
  /// neighbours.
  template <class Team>
  requires requires(Team const& team) { team.league_rank(); }
  SCREE_FN void operator()(Team const& team) const {
    int const i = team.league_rank() * team.team_size() + team.team_rank();
    if (i >= targets) return;
    auto const self = reads.load(i);
    Total total;
    Kokkos::parallel_reduce(
        Kokkos::ThreadVectorRange(team, lanes),
        [&](int lane, Total& part) {
          part = sum(i, self, {lane, lanes});
        },
        AddTotals<P, Adds>(total));
    Kokkos::single(Kokkos::PerThread(team), [&] { finish(i, self, total); });
  }

 private:
  template <class I>
  SCREE_FN Total sum(int i, I const& self, LaneRange range) const {
    Sums<P, Adds> sums;
    if (where(self)) (static_cast<Indexed<K, Sources> const&>(*this).source.add(i, self, kernel, range, sums), ...);
    return sums.totals();
  }
  template <class I>
  SCREE_FN void finish(int i, I const& self, Total const& total) const {
    if constexpr (stores_sums<Then>) {
      stored.store(i, total);
    } else {
      Results<P, Stored> results;
      then(self, total, results);
      stored.store(i, results);
    }
  }
};

}  // namespace detail

/// The options of a pair loop.
template <class P, class Where = Everywhere, class Then = StoreSums>
struct PairLoopOptions {
  PassLabel label;      ///< the name of the loop in profiles
  kernel_of<P> kernel;  ///< the kernel with its smoothing length
  Where where = {};     ///< the particles that sum over their neighbours
  Then then = {};       ///< the function of a particle's sums, or StoreSums
};

/// One source of a pair loop: a body, the search that finds its particles, a lens, and the terms to be summed over the
/// body.
template <class Body, class Search, class Lens, class... Terms>
struct From {
  using adds = Merge<adds_of<Terms>...>;
  template <class P>
  static constexpr bool are_terms = (PairTerm<Terms, P> && ...);

  Body const& body;
  Search const& search;
  Lens lens;
  detail::Tuple<Terms...> terms;
};
/// Returns the source that sums terms over the particles of a body with the particles' own values.
template <class Body, class Search, class... Terms>
From<Body, Search, AsIs, Terms...> from(Body const& body, Search const& search, Terms const&... terms) {
  return {body, search, AsIs{}, {terms...}};
}
/// Returns the source that sums terms over the particles of a body with the values that a lens gives.
template <class Lens, class Body, class Search, class... Terms>
From<Body, Search, Lens, Terms...> through(Lens const& lens, Body const& body, Search const& search,
                                           Terms const&... terms) {
  return {body, search, lens, {terms...}};
}

namespace detail {
/// Whether all parts of a pair loop meet their concepts; otherwise the compiler reports the parts that do not.
template <class P, class Where, class Then, class... Froms>
constexpr bool explain_pair_loop() {
  constexpr bool are_terms = (Froms::template are_terms<P> && ...), is_condition = ParticleCondition<Where, P>;
  static_assert(are_terms,
                "this is not a PairTerm: it needs lists `reads` and `adds`, and operator()(i, j, ij, sum) const");
  static_assert(is_condition,
                "the condition of this pass needs a list `reads` and operator()(i) const, which returns a bool");
  if constexpr (are_terms && is_condition) {
    constexpr bool takes_sums = stores_sums<Then> || FunctionOfSums<Then, P, Merge<typename Froms::adds...>>;
    static_assert(takes_sums,
                  "the function of the sums of this pass needs lists `reads` and `writes`, and operator()(i, total, "
                  "out) const");
    return takes_sums;
  }
  return false;
}
template <class P, class Body, class Search, class Lens, class... Terms>
auto make_source(typename P::space const& space, void const* targets, From<Body, Search, Lens, Terms...> const& from) {
  using S = Source<P, decltype(from.search.view()), Lens, Terms...>;
  check_same_instance(space, from.body.space());
  return with_values(
      [&](Terms const&... terms) {
        return S(from.body.select(typename S::stored{}), from.search.view(), from.lens,
                 static_cast<void const*>(&from.body) == targets, terms...);
      },
      from.terms);
}

// Teams are small enough for a few thousand particles to occupy the whole GPU.
inline constexpr int threads_per_team = 64;
// In single precision, a pass is bound by memory latency, and more teams per multiprocessor gain more than a few more
// registers per thread (docs/performance.md).
template <class P>
using Teams =
    Kokkos::TeamPolicy<typename P::space,
                       std::conditional_t<std::is_same_v<typename P::real, float>,
                                          Kokkos::LaunchBounds<threads_per_team, 14>, Kokkos::LaunchBounds<>>>;

/// The type of the loop that sums over the given sources.
template <class P, class Where, class Then, class... Sources>
using PairLoopOver =
    PairLoop<P, Merge<Fields<Position>, typename Sources::reads_i..., reads_of<Where>, reads_of<Then>>,
             Merge<typename Sources::adds...>, Where, Then, std::index_sequence_for<Sources...>, Sources...>;

/// Whether the library scree::compiled contains a pair loop; if so, run_compiled_loop() runs it.
template <class P, class Loop>
struct is_compiled_loop : std::false_type {};
template <class P, class Loop>
void run_compiled_loop(typename P::space const& space, PassLabel const& label, Loop const& loop);

/// Runs a pair loop on the host or, in teams of threads, on a GPU.
template <class P, class Loop>
void run_loop(typename P::space const& space, PassLabel const& label, Loop const& loop) {
  if constexpr (runs_on_host<P>) {
    for_each_index(space, label, 0, loop.targets, loop);
  } else {
    int const team = threads_per_team / loop.lanes, teams = (loop.targets + team - 1) / team;
    if (teams > 0) Kokkos::parallel_for(std::string(label.text()), Teams<P>(space, teams, team, loop.lanes), loop);
  }
}
template <class P, class Where, class Then, class Targets, class... Sources>
void run_pair_loop(PairLoopOptions<P, Where, Then> const& options, Targets const& targets, Sources const&... sources) {
  using Loop = PairLoopOver<P, Where, Then, Sources...>;
  Loop const loop(targets.select(typename Loop::Reads{}), targets.select(typename Loop::Stored{}), options.kernel,
                  options.where, options.then, targets.size(), targets.everywhere(), sources...);
  if constexpr (is_compiled_loop<P, Loop>::value)
    run_compiled_loop<P>(targets.space(), options.label, loop);
  else
    run_loop<P>(targets.space(), options.label, loop);
}
}  // namespace detail

/// Sums the terms of each source, for each owned target i, over the particles of the source's body within the support,
/// and stores the sums (overwriting the fields) or the result of `then`. The sums of targets for which `where(i)` is
/// false are zero. Results do not depend on the number of threads. Pairs are summed in the order of the search, with
/// two exceptions: several lanes that share a target each sum their own part (lanes_for()), and the pair of a particle
/// with itself comes last if pairs are summed in packs.
template <class P, class Where, class Then, class Targets, class... Froms>
void for_each_pair(PairLoopOptions<P, Where, Then> const& options, Targets const& targets, Froms const&... froms) {
  if constexpr (detail::explain_pair_loop<P, Where, Then, Froms...>())
    detail::run_pair_loop(options, targets, detail::make_source<P>(targets.space(), &targets, froms)...);
}

}  // namespace scree
