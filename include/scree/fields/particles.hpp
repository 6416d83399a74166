// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "columns.hpp"
#include "position_guard.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scree {
namespace detail {

/// Throws std::invalid_argument unless there is a value of the named field for each of the owned particles.
void require_values(std::string_view field, std::size_t values, int owned);
/// Throws std::invalid_argument unless there is a value of the named field for each owned particle from number `first`
/// on.
void require_values_from(std::string_view field, std::size_t values, int first, int owned);

/// Columns of values of known sizes; owned particles come first, ghosts after them. Types do not matter here.
template <class Space>
class UntypedParticles {
 public:
  using MemorySpace = typename Space::memory_space;
  struct Kind {
    std::string_view name;
    std::size_t bytes;   // of a value
    std::size_t stride;  // from one value to the next
  };

  UntypedParticles(Space const& space, std::vector<Kind> kinds)
      : space_(space), kinds_(std::move(kinds)), columns_(kinds_.size()) {}

  Space const& space() const { return space_; }
  int size() const { return owned_; }
  std::size_t kinds() const { return kinds_.size(); }
  int ghosts() const { return ghosts_; }
  int extent() const { return owned_ + ghosts_; }

  void resize(int owned, int ghosts);
  /// Reserves memory for a number of particles, ghosts included.
  void reserve(int extent) {
    if (extent > capacity_) set_capacity(extent);
  }
  /// Copies owned values to the host, without gaps, and back.
  void to_host(std::size_t column, void* values) const;
  void from_host(std::size_t column, void const* values) const { from_host(column, values, 0); }
  /// Copies values from the host to the owned particles from number `first` on.
  void from_host(std::size_t column, void const* values, int first) const;
  /// Whether all bytes of the owned values are zero.
  bool is_zero(std::size_t column) const;
  void reorder(Span<int const> order) { rearrange(order, std::max(1, order.size())); }
  void keep(Span<int const> rising);
  /// Adds owned particles with zeros, in place of the ghosts; returns the number of the first.
  int append(int number);
  /// Copies the values of some particles to the host, without gaps.
  void to_host(std::size_t column, Span<int const> which, void* values) const;
  void fill(std::size_t column, Memory<MemorySpace> const& value);
  Memory<MemorySpace> const& memory(std::size_t column) const { return columns_[column]; }
  UntypedColumn untyped(std::size_t column) const { return untyped(columns_[column], column); }
  /// Other memory viewed as if it belonged to a column.
  UntypedColumn untyped(Memory<MemorySpace> const& memory, std::size_t column) const {
    using Word = UntypedColumn::Word;
    return {reinterpret_cast<Word*>(memory.data()), static_cast<int>(kinds_[column].stride / sizeof(Word))};
  }

 private:
  void to_host(void* values, void const* column, std::size_t count, std::size_t bytes, std::size_t stride) const;
  /// Keeps the particles of a list in its order, with zeros behind them, through a buffer for a block of the widest
  /// column. With several blocks the list must be ascending, so that no block overwrites values that a later one reads.
  void rearrange(Span<int const> order, int block);
  void grow(int extent);
  void set_capacity(int capacity);
  Memory<MemorySpace> new_column(std::size_t kind) const;

  Space space_;
  std::vector<Kind> kinds_;
  std::vector<Memory<MemorySpace>> columns_;
  int owned_ = 0, ghosts_ = 0, capacity_ = 0;
};

template <class Space>
void UntypedParticles<Space>::resize(int owned, int ghosts) {
  if (owned < 0 || ghosts < 0) throw std::invalid_argument("scree: negative number of particles");
  check_number(double(owned) + double(ghosts));
  if (owned + ghosts > capacity_ || capacity_ == 0) grow(owned + ghosts);
  owned_ = owned;
  ghosts_ = ghosts;
}

template <class Space>
void UntypedParticles<Space>::to_host(std::size_t column, void* values) const {
  auto const [name, bytes, stride] = kinds_[column];
  to_host(values, columns_[column].data(), std::size_t(owned_), bytes, stride);
}

template <class Space>
void UntypedParticles<Space>::from_host(std::size_t column, void const* values, int first) const {
  auto const [name, bytes, stride] = kinds_[column];
  std::byte* const to = columns_[column].data() + std::size_t(first) * stride;
  std::size_t const count = std::size_t(owned_ - first);
  if (bytes == stride) return copy_bytes<MemorySpace, Kokkos::HostSpace>(space_, to, values, count * stride);
  std::vector<std::byte> elements(count * stride);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(elements.data() + i * stride, static_cast<std::byte const*>(values) + i * bytes, bytes);
  copy_bytes<MemorySpace, Kokkos::HostSpace>(space_, to, elements.data(), elements.size());
}

template <class Space>
bool UntypedParticles<Space>::is_zero(std::size_t column) const {
  std::vector<unsigned char> values(std::size_t(owned_) * kinds_[column].bytes);
  to_host(column, values.data());
  return std::all_of(values.begin(), values.end(), [](unsigned char byte) { return byte == 0; });
}

template <class Space>
void UntypedParticles<Space>::keep(Span<int const> rising) {
  if (reduce(space_, "scree::falls", rising.size(), CountFalls{rising}) > 0)
    throw std::invalid_argument("scree: the list of particles that are kept does not rise");
  rearrange(rising, 1 << 21);
}

template <class Space>
int UntypedParticles<Space>::append(int number) {
  int const first = owned_;
  if (number < 0) throw std::invalid_argument("scree: negative number of particles");
  check_number(double(first) + double(number));
  resize(first + number, 0);
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    for_each_index(space_, "scree::append", first, owned_, SetZero{untyped(k)});
  return first;
}

template <class Space>
void UntypedParticles<Space>::to_host(std::size_t column, Span<int const> which, void* values) const {
  auto const [name, bytes, stride] = kinds_[column];
  Memory<MemorySpace> const picked("scree::picked", std::size_t(which.size()) * stride);
  for_each_index(space_, "scree::pick", 0, which.size(), Gather{untyped(column), untyped(picked, column), which});
  to_host(values, picked.data(), std::size_t(which.size()), bytes, stride);
}

template <class Space>
void UntypedParticles<Space>::fill(std::size_t column, Memory<MemorySpace> const& value) {
  for_each_index(space_, "scree::fill", 0, extent(), Repeat{untyped(value, column), untyped(column)});
}

template <class Space>
void UntypedParticles<Space>::to_host(void* values, void const* column, std::size_t count, std::size_t bytes,
                                      std::size_t stride) const {
  if (bytes == stride) return copy_bytes<Kokkos::HostSpace, MemorySpace>(space_, values, column, count * stride);
  std::vector<std::byte> elements(count * stride);
  copy_bytes<Kokkos::HostSpace, MemorySpace>(space_, elements.data(), column, elements.size());
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(static_cast<std::byte*>(values) + i * bytes, elements.data() + i * stride, bytes);
}

template <class Space>
void UntypedParticles<Space>::rearrange(Span<int const> order, int block) {
  std::size_t widest = 0;
  for (Kind const& kind : kinds_) widest = std::max(widest, kind.stride);
  int const number = order.size();
  Memory<MemorySpace> const between("scree::reorder", std::size_t(std::min(block, number)) * widest);
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    auto const column = untyped(k), there = untyped(between, k);
    for (std::int64_t first = 0; first < number; first += block) {
      int const begin = int(first), count = std::min(block, number - begin);
      for_each_index(space_, "scree::reorder", 0, count,
                     Gather{column, there, Span<int const>(order.data() + begin, count)});
      for_each_index(space_, "scree::put_back", 0, count, PutAt{there, column, begin});
    }
    for_each_index(space_, "scree::zeros_behind", number, capacity_, SetZero{column});
  }
  owned_ = number;
  ghosts_ = 0;
}

template <class Space>
void UntypedParticles<Space>::grow(int extent) {
  int const spare = capacity_ == 0 ? 0 : std::min(extent / 8, most_particles - extent);
  set_capacity(extent + spare);
}

template <class Space>
void UntypedParticles<Space>::set_capacity(int capacity) {
  double before = 0, bytes = 0, largest = 0;  // a column is there twice while it is copied
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    bytes += double(kinds_[k].stride);
    before += double(columns_[k].size()), largest = std::max(largest, double(columns_[k].size()));
  }
  check_bytes(capacity, double(capacity) * bytes - before + largest, free_memory<MemorySpace>(),
              on_host<MemorySpace> ? "memory" : "memory of the device");
  capacity_ = capacity;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    auto const wider = new_column(k);
    copy_bytes<MemorySpace, MemorySpace>(space_, wider.data(), columns_[k].data(), columns_[k].size());
    columns_[k] = wider;
  }
}

template <class Space>
Memory<typename Space::memory_space> UntypedParticles<Space>::new_column(std::size_t kind) const {
  Memory<MemorySpace> const column(std::string(kinds_[kind].name), std::size_t(capacity_) * kinds_[kind].stride);
  column.fill_with_zeros(space_);
  return column;
}

}  // namespace detail

/// Particles of one body: one array per field, `particles[velocity]`. Owned particles come first, ghosts (periodic
/// images today, particles of other processes later) after them. Loops run over owned particles and read both, on the
/// execution-space instance that the particles were made on.
template <class P, class List>
class Particles;

template <class P, class... Fs>
class Particles<P, Fields<Fs...>> {
  template <class F>
  using Element = typename detail::Element<P, value_t<P, F>>::type;
  static_assert(((sizeof(Element<Fs>) % sizeof(UntypedColumn::Word) == 0) && ...),
                "the size of a field's value must be a multiple of four bytes");

 public:
  using policy = P;
  using fields = Fields<Fs...>;

  Particles(Particles&&) = default;
  Particles& operator=(Particles&&) = default;
  Particles(Particles const&) = delete;  // a copy would share the fields

  explicit Particles(typename P::space const& space, int owned = 0)
      : columns_(space, {{Fs::name, sizeof(value_t<P, Fs>), sizeof(Element<Fs>)}...}) {
    resize(owned);
  }
  /// On the default instance.
  explicit Particles(int owned = 0) : Particles(typename P::space(), owned) {}

  typename P::space const& space() const { return columns_.space(); }

  int size() const { return columns_.size(); }
  int ghosts() const { return columns_.ghosts(); }
  int extent() const { return columns_.extent(); }
  /// The number of owned particles of all ranks of the case: that of the lanes which share a target follows from it.
  long everywhere() const { return std::max(everywhere_, long(size())); }
  void set_everywhere(long particles) { everywhere_ = particles; }

  /// Sets the numbers of owned and ghost particles; values of remaining owned particles are kept. Throws
  /// std::invalid_argument for negative numbers, and for more particles than an int can count or the memory of the host
  /// or of the device can hold.
  void resize(int owned, int ghosts = 0) {
    columns_.resize(owned, ghosts);
    guard_ = {};
  }

  /// Reserves memory for a number of particles, ghosts included, so that a lack of memory is reported now. Throws as
  /// resize() does.
  void reserve(int extent) { columns_.reserve(extent); }

  /// Permutes the owned particles: entry k becomes the particle that was at order(k). Particles that are not in the
  /// order are removed, and so are all ghosts.
  void reorder(Array<P, int const> const& order) {
    columns_.reorder(order);
    guard_ = {};
  }
  /// Keeps the particles of a list that rises, and removes the others and all ghosts. It needs less memory than
  /// reorder(). Throws std::invalid_argument if the list does not rise.
  void keep(Array<P, int const> const& rising) {
    columns_.keep(rising);
    guard_ = {};
  }
  /// Adds owned particles behind the others, with zeros in all fields, and removes all ghosts. Returns the number of
  /// the first. Throws as resize() does.
  int append(int number) {
    guard_ = {};
    return columns_.append(number);
  }

  /// The array of one field; entries [size(), extent()) belong to ghosts.
  template <Field F>
  Array<P, value_t<P, F>> operator[](F) const {
    return {space(), columns_.memory(place<F>), extent()};
  }
  /// The values of one field, for kernels.
  template <Field F>
  Column<P, F> column(F) const {
    return {reinterpret_cast<Element<F>*>(columns_.memory(place<F>).data()), extent()};
  }
  /// The values of some fields, for kernels.
  template <class... Gs>
  Columns<P, Fields<Gs...>> select(Fields<Gs...>) const {
    return {{column(Gs{})}...};
  }
  /// The values of one field without its type, for kernels.
  template <Field F>
  UntypedColumn untyped(F) const {
    return columns_.untyped(place<F>);
  }

  /// Loops that move particles report to this guard.
  void guard_positions(detail::PositionGuard<P> const& guard) { guard_ = guard; }
  detail::PositionGuard<P> const& position_guard() const { return guard_; }

  /// The columns in the order of `fields`, untyped.
  detail::UntypedParticles<typename P::space> const& columns() const { return columns_; }

  /// A host copy of the owned particles' values.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(size()));
    columns_.to_host(place<F>, values.data());
    return values;
  }
  /// A host copy of the values of some particles, given by their indices.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F, Array<P, int const> const& which) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(which.size()));
    columns_.to_host(place<F>, which, values.data());
    return values;
  }
  /// Sets the values of the owned particles from number `first` on.
  template <Field F>
  void from_host(F, std::vector<value_t<P, F>> const& values, int first) {
    detail::require_values_from(F::name, values.size(), first, size());
    columns_.from_host(place<F>, values.data(), first);
    set_[place<F>] = true;
  }
  template <Field F>
  void from_host(F, std::vector<value_t<P, F>> const& values) {
    detail::require_values(F::name, values.size(), size());
    columns_.from_host(place<F>, values.data());
    set_[place<F>] = true;
  }
  template <Field F>
  void fill(F, value_t<P, F> const& value) {
    columns_.fill(place<F>, array_of<P>(space(), std::vector<value_t<P, F>>{value}).memory());
    set_[place<F>] = true;
  }
  /// Whether a field was never set by one of these functions and is zero everywhere.
  template <Field F>
  bool is_unset(F) const {
    return !set_[place<F>] && columns_.is_zero(place<F>);
  }

 private:
  template <Field F>
  static constexpr std::size_t find() {
    static_assert(OneOf<F, fields>, "these particles do not carry this field");
    std::size_t k = 0;
    (void)((std::is_same_v<F, Fs> || (++k, false)) || ...);
    return k;
  }
  template <Field F>
  static constexpr std::size_t place = find<F>();

  detail::UntypedParticles<typename P::space> columns_;
  std::array<bool, sizeof...(Fs) + 1> set_ = {};  // one more than needed: an array must not be empty
  detail::PositionGuard<P> guard_;
  long everywhere_ = 0;  // 0: they are all here
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "particles.ipp"
#endif
