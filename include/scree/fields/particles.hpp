// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "columns.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace scree {
namespace detail {

template <class View, class Order>
struct Gather {
  View from, to;
  Order order;
  SCREE_FN void operator()(int k) const { to(k) = from(order(k)); }
};

}  // namespace detail

/// Particles of one body: one array per field, `particles[velocity]`. Owned particles come first, ghosts (periodic
/// images today, particles of other processes later) behind them. Loops run over owned particles and look at all.
template <class P, class List>
class Particles;

template <class P, class... Fs>
class Particles<P, Fields<Fs...>> {
 public:
  using policy = P;
  using fields = Fields<Fs...>;

  explicit Particles(int owned = 0) { resize(owned); }

  int size() const { return owned_; }
  int ghosts() const { return ghosts_; }
  int extent() const { return owned_ + ghosts_; }

  /// Sets the numbers of owned and ghost particles; values of owned particles that remain are kept.
  void resize(int owned, int ghosts = 0) {
    if (owned < 0 || ghosts < 0) throw std::invalid_argument("scree: negative number of particles");
    owned_ = owned;
    ghosts_ = ghosts;
    if (extent() <= capacity_ && capacity_ > 0) return;
    capacity_ = capacity_ == 0 ? extent() : extent() + extent() / 8;
    (grow(Fs{}), ...);
  }

  /// Puts the owned particles into another order, a permutation that the device can call: at k what was at order(k).
  template <class Order>
  void reorder(Order const& order) {
    (reorder_column(Fs{}, order), ...);
  }

  /// The array of one field; entries [size(), extent()) belong to ghosts.
  template <Field F>
  auto operator[](F field) const {
    return Kokkos::subview(columns_[field], Kokkos::pair<int, int>(0, extent()));
  }

  /// The arrays of some fields, to be copied into a kernel.
  template <class... Gs>
  Columns<P, Fields<Gs...>> select(Fields<Gs...> list) const {
    return columns_.select(list);
  }

  /// A copy on the host, of owned particles.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F field) const {
    return values_of(owned(field));
  }
  template <Field F>
  void from_host(F field, std::vector<value_t<P, F>> const& values) {
    if (static_cast<int>(values.size()) != owned_)
      throw std::invalid_argument("scree: " + std::string(F::name) + " needs one value for each owned particle");
    copy_into(owned(field), values);
  }
  template <Field F>
  void fill(F field, value_t<P, F> const& value) {
    Kokkos::deep_copy((*this)[field], value);
  }

 private:
  template <Field F>
  auto owned(F field) const {
    return Kokkos::subview(columns_[field], Kokkos::pair<int, int>(0, owned_));
  }
  template <Field F>
  Column<P, F> new_column(F) const {
    Column<P, F> const column(Kokkos::view_alloc(std::string(F::name), Kokkos::WithoutInitializing), capacity_);
    Kokkos::deep_copy(column, zero<value_t<P, F>>());
    return column;
  }
  template <Field F>
  void grow(F field) {
    auto& column = static_cast<detail::ColumnSlot<P, F>&>(columns_).view;
    auto const wider = new_column(field);
    Kokkos::pair<int, int> const kept(0, static_cast<int>(column.extent(0)));
    Kokkos::deep_copy(Kokkos::subview(wider, kept), column);
    column = wider;
  }
  template <Field F, class Order>
  void reorder_column(F field, Order const& order) {
    auto& column = static_cast<detail::ColumnSlot<P, F>&>(columns_).view;
    auto const reordered = new_column(field);  // zero behind the owned particles, as after growth
    Kokkos::parallel_for("scree::reorder", Kokkos::RangePolicy<typename P::space>(0, owned_),
                         detail::Gather<Column<P, F>, Order>{column, reordered, order});
    column = reordered;
  }

  Columns<P, fields> columns_;
  int owned_ = 0, ghosts_ = 0, capacity_ = 0;
};

}  // namespace scree
