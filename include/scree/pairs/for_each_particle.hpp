// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "term.hpp"

#include "../core/loop.hpp"
#include "../fields/columns.hpp"
#include "../fields/position_guard.hpp"
#include "../fields/standard.hpp"

#include <string_view>

namespace scree {
namespace detail {

template <class P, class Function>
struct ParticleLoop : Function {
  static constexpr bool moves = has_trials<typename P::space> && OneOf<Position, writes_of<Function>>;
  struct NoGuard {};
  using Guard = std::conditional_t<moves, PositionGuard<P>, NoGuard>;

  Columns<P, reads_of<Function>> reads;
  Columns<P, writes_of<Function>> writes;
  Guard guard;

  ParticleLoop(Function const& f, Columns<P, reads_of<Function>> const& r, Columns<P, writes_of<Function>> const& w,
               Guard const& g)
      : Function(f), reads(r), writes(w), guard(g) {}

  SCREE_FN void operator()(int i) const {
    Results<P, writes_of<Function>> results;
    if constexpr (moves) {
      auto const start = guard.start(i);
      update(i, results);
      guard.look(start, results[Position{}]);
    } else {
      update(i, results);
    }
  }

 private:
  SCREE_FN void update(int i, Results<P, writes_of<Function>>& results) const {
    static_cast<Function const&> (*this)(reads.load(i), results);
    writes.store(i, results);
  }
};

template <class P, class First, class Second>
struct TwoParticleLoops {
  ParticleLoop<P, First> first;
  ParticleLoop<P, Second> second;
  int of_first;
  SCREE_FN void operator()(int i) const {
    if (i < of_first)
      first(i);
    else
      second(i - of_first);
  }
};

template <class P, class Function, class Body>
ParticleLoop<P, Function> particle_loop(Body const& body, Function const& function) {
  static_assert(PointFunction<Function, P>,
                "this is not a PointFunction: it needs lists `reads` and `writes`, and operator()(i, out) const");
  using Loop = ParticleLoop<P, Function>;
  typename Loop::Guard guard;
  if constexpr (Loop::moves) guard = body.position_guard();
  return {function, body.select(reads_of<Function>{}), body.select(writes_of<Function>{}), guard};
}

}  // namespace detail

/// Applies a function of one particle to each owned particle of a body.
template <class P, class Function, class Body>
void for_each_particle(std::string_view label, Body const& body, Function const& function) {
  static_assert(PointFunction<Function, P>,
                "this is not a PointFunction: it needs lists `reads` and `writes`, and operator()(i, out) const");
  if constexpr (PointFunction<Function, P>)
    for_each_index(body.space(), label, 0, body.size(), detail::particle_loop<P>(body, function));
}

/// Applies one function to the particles of body `a` and another to the particles of body `b`, in one kernel launch.
template <class P, class First, class Second, class A, class B>
void for_each_particle_of_two(std::string_view label, A const& a, First const& first, B const& b,
                              Second const& second) {
  using Loops = detail::TwoParticleLoops<P, First, Second>;
  check_same_instance(a.space(), b.space());
  for_each_index(a.space(), label, 0, a.size() + b.size(),
                 Loops{detail::particle_loop<P>(a, first), detail::particle_loop<P>(b, second), a.size()});
}

}  // namespace scree
