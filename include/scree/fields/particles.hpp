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
#include <type_traits>
#include <vector>

namespace scree {

/// A list of column numbers of a body, in the order of its fields. The list refers to an array that must outlive it.
class ColumnNumbers {
 public:
  /// Makes an empty list of columns.
  constexpr ColumnNumbers() = default;
  /// Refers to the first `size` numbers of an array.
  constexpr ColumnNumbers(std::size_t const* numbers, std::size_t size) : numbers_(numbers), size_(size) {}
  /// Refers to all numbers of an array.
  template <std::size_t Size>
  constexpr ColumnNumbers(std::array<std::size_t, Size> const& numbers) : ColumnNumbers(numbers.data(), Size) {}
  /// Refers to all numbers of a vector.
  ColumnNumbers(std::vector<std::size_t> const& numbers) : ColumnNumbers(numbers.data(), numbers.size()) {}
  /// Whether the list is empty.
  bool empty() const { return size_ == 0; }
  /// Returns the number of columns in the list.
  std::size_t size() const { return size_; }
  /// Returns the k-th column number.
  std::size_t operator[](std::size_t k) const { return numbers_[k]; }
  /// Returns the address of the first number.
  std::size_t const* begin() const { return numbers_; }
  /// Returns the address after the last number.
  std::size_t const* end() const { return numbers_ + size_; }

 private:
  std::size_t const* numbers_ = nullptr;
  std::size_t size_ = 0;
};

namespace detail {

/// A variable whose address identifies a field at run time.
template <class F>
inline constexpr char field_key = 0;

template <class All, class List>
struct ColumnNumbersOf;
template <class... All, class... Fs>
struct ColumnNumbersOf<Fields<All...>, Fields<Fs...>> {
  template <class F>
  static constexpr std::size_t number() {
    static_assert(OneOf<F, Fields<All...>>, "these particles do not carry this field");
    std::size_t k = 0;
    (void)((std::is_same_v<F, All> || (++k, false)) || ...);
    return k;
  }
  static constexpr std::array<std::size_t, sizeof...(Fs)> value = {number<Fs>()...};
};

/// Throws std::invalid_argument unless there is one value of the named field for each owned particle.
void require_values(std::string_view field, std::size_t values, int owned);
/// Throws std::invalid_argument unless there is one value of the named field for each owned particle from index `first`
/// on.
void require_values_from(std::string_view field, std::size_t values, int first, int owned);
/// Throws std::logic_error for a field that a body does not carry.
[[noreturn]] void refuse_column(std::string_view field);

/// Columns of particle values with known sizes and unknown types. Owned particles come first, followed by ghosts.
template <class Space>
class UntypedParticles {
 public:
  using MemorySpace = typename Space::memory_space;
  struct Kind {
    std::string_view name;
    std::size_t bytes;   // the size of a value
    std::size_t stride;  // the distance from one value to the next
    void const* field;   // the address of its field_key
  };

  /// Makes one column for each kind. The array of kinds must outlive the particles.
  UntypedParticles(Space const& space, Kind const* kinds, std::size_t count);
  UntypedParticles(UntypedParticles&&) noexcept;
  UntypedParticles& operator=(UntypedParticles&&) noexcept;
  ~UntypedParticles();

  Space const& space() const { return space_; }
  int size() const { return owned_; }
  std::size_t kinds() const { return columns_.size(); }
  /// Returns the column number of a field that is given by the address of its key, or kinds() if there is no such
  /// column.
  std::size_t find(void const* field) const {
    std::size_t k = 0;
    while (k < columns_.size() && kinds_[k].field != field) ++k;
    return k;
  }
  /// Returns the size of a value of a column, in bytes.
  std::size_t bytes_of(std::size_t column) const { return kinds_[column].bytes; }
  int ghosts() const { return ghosts_; }
  int extent() const { return owned_ + ghosts_; }

  void resize(int owned, int ghosts);
  /// Reserves memory for a number of particles, including ghosts.
  void reserve(int extent) {
    if (extent > capacity_) set_capacity(extent);
  }
  /// Copies the values of owned particles in a column to the host (to_host) or from it (from_host), without padding.
  void to_host(std::size_t column, void* values) const;
  void from_host(std::size_t column, void const* values) const { from_host(column, values, 0); }
  /// Copies values from the host to the owned particles from index `first` on.
  void from_host(std::size_t column, void const* values, int first) const;
  /// Whether all bytes of the owned particles' values in a column are zero.
  bool is_zero(std::size_t column) const;
  void reorder(Span<int const> order) { rearrange(order, std::max(1, order.size())); }
  void keep(Span<int const> rising);
  /// Adds owned particles with zeros in all columns, and removes all ghosts. Returns the index of the first new
  /// particle.
  int append(int number);
  /// Copies the values of particles with given indices to the host, without padding.
  void to_host(std::size_t column, Span<int const> which, void* values) const;
  void fill(std::size_t column, Memory<MemorySpace> const& value);
  Memory<MemorySpace> const& memory(std::size_t column) const { return columns_[column]; }
  UntypedColumn untyped(std::size_t column) const { return untyped(columns_[column], column); }
  /// Returns a view of other memory as if it belonged to a column.
  UntypedColumn untyped(Memory<MemorySpace> const& memory, std::size_t column) const {
    using Word = UntypedColumn::Word;
    return {reinterpret_cast<Word*>(memory.data()), static_cast<int>(kinds_[column].stride / sizeof(Word))};
  }

 private:
  void to_host(void* values, void const* column, std::size_t count, std::size_t bytes, std::size_t stride) const;
  /// Keeps the particles of a list in the order of the list, followed by zeros. Values are copied through a buffer for
  /// one block of the widest column. With several blocks, the list must be ascending, so that no block overwrites
  /// values that a later block reads.
  void rearrange(Span<int const> order, int block);
  void grow(int extent);
  void set_capacity(int capacity);
  Memory<MemorySpace> new_column(std::size_t kind) const;

  Space space_;
  Kind const* kinds_;
  std::vector<Memory<MemorySpace>> columns_;
  int owned_ = 0, ghosts_ = 0, capacity_ = 0;
};

template <class Space>
UntypedParticles<Space>::UntypedParticles(Space const& space, Kind const* kinds, std::size_t count)
    : space_(space), kinds_(kinds), columns_(count) {}
template <class Space>
UntypedParticles<Space>::UntypedParticles(UntypedParticles&&) noexcept = default;
template <class Space>
UntypedParticles<Space>& UntypedParticles<Space>::operator=(UntypedParticles&&) noexcept = default;
template <class Space>
UntypedParticles<Space>::~UntypedParticles() = default;

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
  auto const [name, bytes, stride, field] = kinds_[column];
  to_host(values, columns_[column].data(), std::size_t(owned_), bytes, stride);
}

template <class Space>
void UntypedParticles<Space>::from_host(std::size_t column, void const* values, int first) const {
  auto const [name, bytes, stride, field] = kinds_[column];
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
  for (std::size_t k = 0; k < columns_.size(); ++k)
    for_each_index(space_, "scree::append", first, owned_, SetZero{untyped(k)});
  return first;
}

template <class Space>
void UntypedParticles<Space>::to_host(std::size_t column, Span<int const> which, void* values) const {
  auto const [name, bytes, stride, field] = kinds_[column];
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
  for (std::size_t k = 0; k < columns_.size(); ++k) widest = std::max(widest, kinds_[k].stride);
  int const number = order.size();
  Memory<MemorySpace> const between("scree::reorder", std::size_t(std::min(block, number)) * widest);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
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
  double before = 0, bytes = 0, largest = 0;  // a column exists twice while it is copied
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    bytes += double(kinds_[k].stride);
    before += double(columns_[k].size()), largest = std::max(largest, double(columns_[k].size()));
  }
  check_bytes(capacity, double(capacity) * bytes - before + largest, free_memory<MemorySpace>(),
              on_host<MemorySpace> ? "memory" : "memory of the device");
  capacity_ = capacity;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
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

/// Returns the column numbers of some fields of a body.
template <class All, class List>
ColumnNumbers column_numbers(List) {
  return detail::ColumnNumbersOf<All, List>::value;
}

/// The particles of one body with any fields, whose columns are found at run time. Owned particles come first, followed
/// by ghosts (periodic images and particles of other ranks). Loops visit only owned particles but also read ghosts;
/// they run on the execution-space instance on which the particles were made.
template <class P>
class AnyParticles {
 public:
  using policy = P;
  using Untyped = detail::UntypedParticles<typename P::space>;

  AnyParticles(AnyParticles const&) = delete;  // a copy would share the fields

  /// Returns the execution-space instance on which loops over the particles run.
  typename P::space const& space() const { return columns_.space(); }
  /// Returns the number of owned particles.
  int size() const { return columns_.size(); }
  /// Returns the number of ghosts.
  int ghosts() const { return columns_.ghosts(); }
  /// Returns the number of owned particles and ghosts.
  int extent() const { return columns_.extent(); }
  /// Returns the number of owned particles on all ranks of the case, which determines how many lanes share a target
  /// (lanes_for()).
  long everywhere() const { return std::max(everywhere_, long(size())); }
  /// Sets the number of owned particles on all ranks of the case.
  void set_everywhere(long particles) { everywhere_ = particles; }

  /// Sets the numbers of owned particles and ghosts, and keeps the values of remaining owned particles. Throws
  /// std::invalid_argument if a number is negative, or if there are more particles than an int can count or the memory
  /// of the host or device can hold.
  void resize(int owned, int ghosts = 0) {
    columns_.resize(owned, ghosts);
    guard_ = {};
  }
  /// Reserves memory for a number of particles, including ghosts, so that a lack of memory is reported immediately.
  /// Throws as resize() does.
  void reserve(int extent) { columns_.reserve(extent); }
  /// Permutes the owned particles, so that the particle at index order(k) moves to index k. Removes all particles whose
  /// indices are not in `order`, and all ghosts.
  void reorder(Array<P, int const> const& order) {
    columns_.reorder(order);
    guard_ = {};
  }
  /// Keeps the particles of an ascending list of indices, and removes all other particles and all ghosts. keep() needs
  /// less memory than reorder(). Throws std::invalid_argument if the list is not in strictly ascending order.
  void keep(Array<P, int const> const& rising) {
    columns_.keep(rising);
    guard_ = {};
  }
  /// Adds owned particles after the existing ones, with zeros in all fields, and removes all ghosts. Returns the index
  /// of the first new particle. Throws as resize() does.
  int append(int number) {
    guard_ = {};
    return columns_.append(number);
  }

  /// Whether the body carries a field.
  template <Field F>
  bool has(F) const {
    return columns_.find(&detail::field_key<F>) < columns_.kinds();
  }
  /// Returns the column number of a field. Throws std::logic_error if the body does not carry the field.
  template <Field F>
  std::size_t number_of(F) const {
    std::size_t const k = columns_.find(&detail::field_key<F>);
    if (k == columns_.kinds()) detail::refuse_column(F::name);
    return k;
  }
  /// Returns the column numbers of some fields. Throws std::logic_error if the body does not carry all of these fields.
  template <class... Fs>
  std::vector<std::size_t> numbers_of(Fields<Fs...>) const {
    return {number_of(Fs{})...};
  }
  /// Returns the array of one field; entries [size(), extent()) belong to ghosts. Throws as number_of() does.
  template <Field F>
  Array<P, value_t<P, F>> operator[](F field) const {
    return array<F>(number_of(field));
  }
  /// Returns the values of one field for use in kernels. Throws as number_of() does.
  template <Field F>
  Column<P, F> column(F field) const {
    return span<F>(number_of(field));
  }
  /// Returns the values of some fields for use in kernels. Throws as number_of() does.
  template <class... Fs>
  Columns<P, Fields<Fs...>> select(Fields<Fs...>) const {
    return {{column(Fs{})}...};
  }
  /// Returns a host copy of the values of a field for the owned particles. Throws as number_of() does.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F field) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(size()));
    columns_.to_host(number_of(field), values.data());
    return values;
  }

  /// Returns a host copy of the values of a field for the particles with given indices. Throws as number_of() does.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F field, Array<P, int const> const& which) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(which.size()));
    columns_.to_host(number_of(field), which, values.data());
    return values;
  }

  /// Sets the guard to which loops that move particles report.
  void guard_positions(detail::PositionGuard<P> const& guard) { guard_ = guard; }
  /// Returns the guard to which loops that move particles report.
  detail::PositionGuard<P> const& position_guard() const { return guard_; }

  /// Returns all columns without their types, in the order of the fields.
  Untyped const& columns() const { return columns_; }

 protected:
  AnyParticles(AnyParticles&&) = default;
  AnyParticles& operator=(AnyParticles&&) = default;
  using Kind = typename Untyped::Kind;
  AnyParticles(typename P::space const& space, Kind const* kinds, std::size_t count) : columns_(space, kinds, count) {}
  template <class F>
  using Element = typename detail::Element<P, value_t<P, F>>::type;
  template <Field F>
  Array<P, value_t<P, F>> array(std::size_t number) const {
    return {space(), columns_.memory(number), extent()};
  }
  template <Field F>
  Column<P, F> span(std::size_t number) const {
    return {reinterpret_cast<Element<F>*>(columns_.memory(number).data()), extent()};
  }

  Untyped columns_;

 private:
  detail::PositionGuard<P> guard_;
  long everywhere_ = 0;  // 0: all particles are on this rank
};

namespace detail {

/// All bodies of a system, in order; they are read-only if `Particles` is const. The list refers to an array of
/// pointers that must outlive it.
template <class Particles>
class BodyList {
 public:
  template <class Same, std::size_t Size>
  BodyList(std::array<Same*, Size> const& bodies) : bodies_(bodies.data()), size_(Size) {}
  BodyList(Particles* const* bodies, std::size_t size) : bodies_(bodies), size_(size) {}
  /// Makes a read-only list of the same bodies.
  template <class Same>
  BodyList(BodyList<Same> const& same) : BodyList(same.data(), same.size()) {}
  Particles* const* data() const { return bodies_; }
  std::size_t size() const { return size_; }
  Particles& operator[](std::size_t k) const { return *bodies_[k]; }

 private:
  Particles* const* bodies_;
  std::size_t size_;
};
/// All bodies of a system.
template <class P>
using AllBodies = BodyList<AnyParticles<P>>;
/// All bodies of a system, read-only.
template <class P>
using AllBodiesRead = BodyList<AnyParticles<P> const>;

}  // namespace detail

/// The particles of one body with given fields, stored as one array per field, such as `particles[velocity]`. Access to
/// a field that the particles do not carry is a compile-time error.
template <class P, class List>
class Particles;

template <class P, class... Fs>
class Particles<P, Fields<Fs...>> : public AnyParticles<P> {
  using Any = AnyParticles<P>;
  using Any::columns_;
  template <class F>
  using Element = typename detail::Element<P, value_t<P, F>>::type;
  static_assert(((sizeof(Element<Fs>) % sizeof(UntypedColumn::Word) == 0) && ...),
                "the size of a field's value must be a multiple of four bytes");

 public:
  using fields = Fields<Fs...>;
  using Any::size;

  explicit Particles(typename P::space const& space, int owned = 0) : Any(space, kinds.data(), kinds.size()) {
    Any::resize(owned);
  }
  /// Makes particles on the default instance of the execution space.
  explicit Particles(int owned = 0) : Particles(typename P::space(), owned) {}

  /// Whether the body carries a field.
  template <Field F>
  static constexpr bool has(F) {
    return OneOf<F, fields>;
  }
  /// Returns the array of one field; entries [size(), extent()) belong to ghosts.
  template <Field F>
  Array<P, value_t<P, F>> operator[](F) const {
    return Any::template array<F>(place<F>);
  }
  /// Returns the values of one field for use in kernels.
  template <Field F>
  Column<P, F> column(F) const {
    return Any::template span<F>(place<F>);
  }
  /// Returns the values of some fields for use in kernels.
  template <class... Gs>
  Columns<P, Fields<Gs...>> select(Fields<Gs...>) const {
    return {{column(Gs{})}...};
  }

  /// Returns a host copy of the values of a field for the owned particles.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(size()));
    columns_.to_host(place<F>, values.data());
    return values;
  }
  /// Returns a host copy of the values of a field for the particles with given indices.
  template <Field F>
  std::vector<value_t<P, F>> to_host(F, Array<P, int const> const& which) const {
    std::vector<value_t<P, F>> values(static_cast<std::size_t>(which.size()));
    columns_.to_host(place<F>, which, values.data());
    return values;
  }
  /// Sets the values of a field for the owned particles from index `first` on. Throws std::invalid_argument unless
  /// there is one value for each of these particles.
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
    columns_.fill(place<F>, array_of<P>(this->space(), std::vector<value_t<P, F>>{value}).memory());
    set_[place<F>] = true;
  }
  /// Whether a field was never set by from_host() or fill() and is zero everywhere.
  template <Field F>
  bool is_unset(F) const {
    return !set_[place<F>] && columns_.is_zero(place<F>);
  }

 private:
  template <Field F>
  static constexpr std::size_t find() {
    return detail::ColumnNumbersOf<fields, Fields<F>>::value[0];
  }
  template <Field F>
  static constexpr std::size_t place = find<F>();
  static constexpr std::array<typename Any::Kind, sizeof...(Fs)> kinds = {
      typename Any::Kind{Fs::name, sizeof(value_t<P, Fs>), sizeof(Element<Fs>), &detail::field_key<Fs>}...};

  std::array<bool, sizeof...(Fs) + 1> set_ = {};  // one more than needed, so that the array is never empty
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "particles.ipp"
#endif
