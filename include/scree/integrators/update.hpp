// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/rate.hpp"
#include "../fields/standard.hpp"

#include <tuple>
#include <utility>

namespace scree {

/// A function of one particle that adds `step` times $dX/dt$ to each field X of a list, in order. A rate that is itself
/// in the list is used after its own update, so Fields<Velocity, Position> moves positions with the new velocity.
template <class P, class Evolved>
struct StaggeredUpdate;
template <class P, class... Fs>
struct StaggeredUpdate<P, Fields<Fs...>> {
  using writes = Merge<Fields<detail::evolved_field<Fs>...>, remainders_of_evolved<P, Fields<Fs...>>>;
  using reads = Merge<writes, rates_of_evolved<Fields<Fs...>>>;
  typename detail::time_for<P, Fields<Fs...>>::type step;  ///< s
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    ((out[detail::evolved_field<Fs>{}] = i[detail::evolved_field<Fs>{}]), ...);
    (add<Fs>(i, out), ...);
  }

 private:
  template <class F, class I, class O>
  SCREE_FN void add(I const& i, O& out) const {
    if constexpr (detail::HasRate<F>) {
      auto const from = i[detail::evolved_field<F>{}];
      if constexpr (OneOf<typename F::rate, writes>)
        evolve<P, F>(from, detail::change<F>(step, out), i, out);
      else
        evolve<P, F>(from, detail::change<F>(step, i), i, out);
    }
  }
};

/// Returns the StaggeredUpdate of a list of fields over `step` (s).
template <class P, class Evolved>
StaggeredUpdate<P, Evolved> staggered_update(Evolved, double step) {
  return {typename detail::time_for<P, Evolved>::type(step)};
}

namespace detail {
template <class Stages, std::size_t... K>
constexpr bool only_last_moves(std::index_sequence<K...>) {
  return (!OneOf<Position, evolved_fields<typename std::tuple_element_t<K, Stages>::evolves>> && ...);
}
/// Whether only the last stage moves particles.
template <class Stages>
inline constexpr bool positions_last =
    only_last_moves<Stages>(std::make_index_sequence<std::tuple_size_v<Stages> - 1>());
}  // namespace detail

}  // namespace scree
