// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "held.hpp"
#include "regions.hpp"

#include <string>
#include <type_traits>

namespace scree {

/// An open end through which material leaves against given values, for instance a stress. Particles beyond the plane
/// take these values after each step. Particles more than one support beyond the plane also keep their velocity (see
/// Held), because there are no particles behind them; particles more than two supports beyond the plane are removed.
/// Material cannot return through an open end.
template <int Dim>
struct OpenEnd {
  std::string name = "end";                            ///< name in the ledger and in messages
  Vec<Dim, double> point = Vec<Dim, double>::Zero();   ///< point of the plane, m
  Vec<Dim, double> normal = Vec<Dim, double>::Zero();  ///< points out of the domain; of any length
};

namespace detail {

/// The value of Held for particles beyond an open end.
inline constexpr int held_by_end = -1;

/// The value that a field keeps: a constant, or a function of the position that a device can call.
template <class F, class Value>
struct KeptValue {
  Value value;
  template <class X, class O>
  SCREE_FN void set(X const& x, O& out) const {
    using Wanted = std::remove_cvref_t<decltype(out[F{}])>;
    if constexpr (std::is_convertible_v<Value, Wanted>)
      out[F{}] = Wanted(value);
    else
      out[F{}] = Wanted(value(x));
  }
};
/// A kernel that sets the given values on particles beyond a plane and holds the particles beyond a second plane.
template <class P, class List, class... Values>
struct KeepBeyond;
template <class P, class... Fs, class... Values>
struct KeepBeyond<P, Fields<Fs...>, Values...> : KeptValue<Fs, Values>... {
  Beyond<P::dim> beyond, far;
  Columns<P, Fields<Position, Held>> before;
  Columns<P, Fields<Held, Fs...>> after;

  KeepBeyond(Beyond<P::dim> const& plane, Beyond<P::dim> const& second_plane,
             Columns<P, Fields<Position, Held>> const& read, Columns<P, Fields<Held, Fs...>> const& written,
             Values const&... values)
      : KeptValue<Fs, Values>{values}..., beyond(plane), far(second_plane), before(read), after(written) {}
  SCREE_FN void operator()(int k) const {
    using namespace fields;
    auto const i = before.load(k);
    if (!beyond(i)) return;
    Results<P, Fields<Held, Fs...>> out;
    out[held] = far(i) ? held_by_end : int(i[held]);
    (static_cast<KeptValue<Fs, Values> const&>(*this).set(i[position], out), ...);
    after.store(k, out);
  }
};

}  // namespace detail
}  // namespace scree
