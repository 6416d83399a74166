// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/record.hpp"
#include "../fields/standard.hpp"

#include <type_traits>

namespace scree {

/// The number of the inlet that pushes a particle, counted from 1; 0: the particle is free; negative: the particle is
/// beyond an open end. A held particle keeps its velocity regardless of the forces on it. A formulation with inlets
/// that push, or with open ends, needs `using carries = Fields<Held>`.
struct Held : Integer<"held by inlet", "1"> {
  static constexpr bool may_stay_zero = true;
};

namespace fields {
inline constexpr Held held{};
}  // namespace fields

namespace detail {

/// The values of a particle, with zero acceleration if the particle is held.
template <class I>
struct HeldPoint {
  I const& i;
  template <Field F>
  SCREE_FN auto operator[](F) const {
    using Value = std::remove_cvref_t<decltype(i[F{}])>;
    Value value = i[F{}];
    if constexpr (std::is_same_v<F, Acceleration>)
      if (i[fields::held] != 0) value = zero<Value>();
    return value;
  }
};
/// An update that keeps the velocity of held particles.
template <class Update>
struct HoldingUpdate {
  using reads = Merge<reads_of<Update>, Fields<Held>>;
  using writes = writes_of<Update>;
  Update update;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    update(HeldPoint<I>{i}, out);
  }
};
/// Returns an update for a body that carries the fields of a list. If particles of the body can be held, the update
/// keeps their velocity.
template <class Carried, class Update>
auto holding(Update const& update) {
  if constexpr (OneOf<Held, Carried> && OneOf<Acceleration, reads_of<Update>>)
    return HoldingUpdate<Update>{update};
  else
    return update;
}

/// An update that releases the particles of an inlet that have passed a plane.
template <class X>
struct Release {
  using reads = Fields<Held, Position>;
  using writes = Fields<Held>;
  int number;
  X direction;                // of unit length
  typename X::Scalar beyond;  // m, along the direction
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    typename X::Scalar along = 0;
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) along += direction[axis] * i[position][axis];
    out[held] = i[held] == number && along > beyond ? 0 : int(i[held]);
  }
};

}  // namespace detail
}  // namespace scree
