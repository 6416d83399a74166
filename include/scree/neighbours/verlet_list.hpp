// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cell_list.hpp"
#include "skin_watch.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree {
namespace detail {

/// A table of candidates in rows. On a host, the entries of a row are contiguous. On a GPU, the entries that the lanes
/// of a target read together are contiguous and are followed by the entries of the next target, so that the reads of a
/// warp coalesce. `OnDevice` is the type of entry numbers on a GPU; 32 bits are faster, because a pair loop has no
/// register to spare.
template <class P, class OnDevice>
struct Table {
  using Number = std::conditional_t<runs_on_host<P>, std::size_t, OnDevice>;
  int* entries = nullptr;
  int rows = 0, capacity = 0;  // number of rows, and capacity of each row
  int lanes = 1;               // a power of two; divides `capacity`

  SCREE_LOOP_FN Number place(int row, int k) const {
    if constexpr (runs_on_host<P>) return Number(row) * Number(capacity) + Number(k);
    Number const lane = Number(k) & Number(lanes - 1);
    return (Number(k) - lane) * Number(rows) + (Number(row) * Number(lanes) + lane);
  }
  SCREE_LOOP_FN int& operator()(int row, int k) const { return entries[place(row, k)]; }
};

/// The candidates of targets, with one row for each target.
template <class P, class OnDevice>
struct CandidateRows {
  static constexpr bool are_numbered = false;
  using Entries = Table<P, OnDevice>;
  Span<int> lengths;  // number of candidates of each target
  Entries table;

  SCREE_LOOP_FN int row_of(int target) const { return target; }
};
/// The candidates of targets, with rows only for targets that have candidates. NumberedRows is a separate type because
/// one more number per thread reduces occupancy.
template <class P, class OnDevice>
struct NumberedRows {
  static constexpr bool are_numbered = true;
  using Entries = Table<P, OnDevice>;
  Span<int> lengths;
  Entries table;
  Span<int> numbers;
  bool numbered = false;  // false: there are few targets, and each has a row

  SCREE_LOOP_FN int row_of(int target) const { return numbered ? numbers(target) : target; }
};

/// A writer that fills a row from its beginning and stores contiguous entries together.
template <class P, class Entries>
class RowWriter {
 public:
  SCREE_FN RowWriter(Entries const& to, int row) : to_(to), row_(row) {}
  SCREE_LOOP_FN void append(int j) {
    if constexpr (!runs_on_host<P>) {
      if (to_.lanes >= together) return append_together(j);
    }
    if (length_ < to_.capacity) to_(row_, length_) = j;
    ++length_;
  }
  /// Finishes the row. Returns the number of entries, including entries that did not fit.
  SCREE_FN int finish() {
    int const length = length_;
    if constexpr (!runs_on_host<P>)
      if (to_.lanes >= together)
        while (length_ % together != 0) append_together(0);
    return length;
  }

 private:
  static constexpr int together = 4;
  struct alignas(sizeof(int) * together) Together {
    int entry[together];
  };
  SCREE_LOOP_FN void append_together(int j) {
    // Entries are shifted rather than indexed, so that they stay in registers.
    for (int k = 0; k + 1 < together; ++k) last_.entry[k] = last_.entry[k + 1];
    last_.entry[together - 1] = j;
    if (++length_ % together == 0) write(length_ - together);
  }
  SCREE_FN void write(int first) const {
    if (first + together <= to_.capacity) *reinterpret_cast<Together*>(&to_(row_, first)) = last_;
  }

  Entries const& to_;
  int row_, length_ = 0;
  Together last_ = {};
};

/// A loop body that fills rows up to their capacity, and counts the candidates of each target.
template <class P, class Rows>
struct FillRows {
  PositionSpan<P> targets;
  typename CellList<P>::View cells;
  Rows to;
  bool only_count;
  bool sorted;  // targets are the sources, taken in cell order, so that neighbouring threads read the same cells

  SCREE_FN void operator()(int k) const {
    int const i = sorted ? cells.sorted(k).index : k;
    if (i >= targets.size()) return;
    to.lengths(i) = only_count ? count(i) : fill(i);
  }

 private:
  SCREE_FN int count(int i) const {
    int length = 0;
    cells.for_each(i, value_of(targets(i)), [&](int) { ++length; });
    return length;
  }
  SCREE_FN int fill(int i) const {
    RowWriter<P, typename Rows::Entries> row(to.table, to.row_of(i));
    cells.for_each(i, value_of(targets(i)), [&](int j) { row.append(j); });
    return row.finish();
  }
};

/// A function for running_sum() that numbers the targets that have candidates.
template <class Rows>
struct NumberRows {
  Rows of;
  SCREE_FN void operator()(int i, int& number, bool last) const {
    if (last) of.numbers(i) = number;
    if (of.lengths(i) > 0) ++number;
  }
};

/// The base of neighbour lists within one body and of neighbour lists between two bodies.
template <class P, class Rows, class Order = ByIndex>
class ListInRows {
 public:
  using Cells = CellList<P, Order>;
  static constexpr double skin = 0.1;   // as a fraction of the radius
  static constexpr int many = 1 << 14;  // least number of targets for numbered rows

  struct View : Rows {
    template <class F>
    SCREE_LOOP_FN void for_each(int i, Vec<P::dim, typename P::real> const&, F const& f, LaneRange range = {}) const {
      int const length = this->lengths(i), row = this->row_of(i);
      // The next entry is fetched before it is needed.
      for (int k = range.lane, j = k < length ? this->table(row, k) : 0; k < length;) {
        int const now = j;
        k += range.lanes;
        if (k < length) j = this->table(row, k);
        f(now);
      }
    }
  };

  [[gnu::cold]] explicit ListInRows(double radius) : watch_(skin * radius, 2), cells_(reach(radius)) {}

  void update(Positions<P> const& targets, Positions<P> const& sources);
  View view() const { return view_; }
  long builds() const { return builds_; }

  /// Returns the radius (m) of the cells that lists of several bodies share, for a given search radius (m).
  static double reach(double radius) { return (1 + skin) * radius; }
  /// Builds the list from given cells, for a caller that tracks the validity of the list itself.
  void build(Positions<P> const& targets, Positions<P> const& sources, typename CellList<P>::View const& cells);

 private:
  static Places<P> all_owned(Positions<P> const& x) { return {x, x.size()}; }
  /// Numbers the targets that have rows, and returns the number of rows.
  int number_rows(typename P::space const& space, int targets);
  /// Allocates `rows` rows of the given length, with some slack in the dimension that was too small.
  void reserve_rows(int targets, int rows, int length);

  SkinWatch<P> watch_;  // of targets and other sources
  Cells cells_;
  long builds_ = 0;
  Array<P, int> lengths_, numbers_;
  Memory<memory_of<P>> entries_;
  View view_;
};

template <class P, class Rows, class Order>
void ListInRows<P, Rows, Order>::update(Positions<P> const& targets, Positions<P> const& sources) {
  bool const same = targets.data() == sources.data() && targets.size() == sources.size();
  std::vector<Places<P>> const now{all_owned(targets), same ? Places<P>() : all_owned(sources)};
  if (watch_.serves(watch_.crossed(now))) return;
  watch_.keep(now);
  cells_.update(targets, sources);
  build(targets, sources, cells_.view());
}

template <class P, class Rows, class Order>
void ListInRows<P, Rows, Order>::build(Positions<P> const& targets, Positions<P> const& sources,
                                       typename CellList<P>::View const& cells) {
  ProfilingRegion const region("scree::verlet_list");
  auto const& space = targets.space();
  int const n = targets.size();
  reserve(space, lengths_, "scree::verlet_list", std::size_t(n));
  view_.lengths = lengths_;
  bool const sorted = targets.data() == sources.data();
  auto const longest_of = [&](bool only_count) {
    for_each_index(space, "scree::verlet_rows", 0, sorted ? sources.size() : n,
                   FillRows<P, Rows>{targets, cells, view_, only_count, sorted});
    return reduce(space, "scree::longest_row", n, LargestValue{view_.lengths});
  };
  int rows = n, longest = view_.table.capacity;
  if constexpr (Rows::are_numbered) {
    view_.numbered = n >= many;
    if (view_.numbered) {
      longest = longest_of(true);
      rows = number_rows(space, n);
    }
  }
  do reserve_rows(n, rows, longest);
  while ((longest = longest_of(false)) > view_.table.capacity);
  ++builds_;
}

template <class P, class Rows, class Order>
int ListInRows<P, Rows, Order>::number_rows([[maybe_unused]] typename P::space const& space, int targets) {
  if constexpr (Rows::are_numbered) {
    reserve(space, numbers_, "scree::verlet_list", std::size_t(targets));
    view_.numbers = numbers_;
    return running_sum(space, "scree::verlet_numbers", targets, NumberRows<View>{view_});
  }
  return targets;
}

template <class P, class Rows, class Order>
void ListInRows<P, Rows, Order>::reserve_rows(int targets, int rows, int length) {
  auto& table = view_.table;
  if (rows <= table.rows && length <= table.capacity) return;
  table.lanes = lanes_for<P>(targets);
  int const needed = length > table.capacity ? length + length / 32 : table.capacity;
  table.capacity = (needed + table.lanes - 1) / table.lanes * table.lanes;
  table.rows = rows > table.rows && Rows::are_numbered ? rows + rows / 16 : std::max(rows, table.rows);
  if (double(table.rows) * table.capacity > double(std::numeric_limits<typename Rows::Entries::Number>::max()))
    throw std::runtime_error("scree: " + std::to_string(table.rows) + " lists of " + std::to_string(table.capacity) +
                             " neighbours are more than 32 bits can count: use `search = LargeVerletList`, on ranks "
                             "LargeReproducibleList");
  std::size_t const entries = std::size_t(table.rows) * std::size_t(table.capacity) * sizeof(int);
  if (entries_.size() < entries) {
    entries_ = {};  // frees the old memory before the new is allocated
    entries_ = Memory<memory_of<P>>("scree::verlet_rows", entries);
  }
  table.entries = reinterpret_cast<int*>(entries_.data());
}

}  // namespace detail

/// A search that stores the candidates within a distance of radius (1 + skin) from each target and keeps them until
/// particles may have crossed the skin; see SkinWatch. OfOthers is the type for sources other than the targets, such as
/// wall particles as sources for the material. This type has rows only for targets with candidates, unless there are so
/// few targets that numbering them costs more than it saves in memory. On a GPU, all targets together can have at most
/// 2^32 candidates, which corresponds to some 28 million particles in 3D.
template <class P>
struct VerletList : detail::ListInRows<P, detail::CandidateRows<P, std::uint32_t>> {
  using detail::ListInRows<P, detail::CandidateRows<P, std::uint32_t>>::ListInRows;
  using OfOthers = detail::ListInRows<P, detail::NumberedRows<P, std::uint32_t>>;
};

/// A VerletList with rows in an order that depends only on the positions, so that results are bitwise identical however
/// the particles are stored, sorted or divided among ranks (docs/distributed.md).
template <class P>
struct ReproducibleList : detail::ListInRows<P, detail::CandidateRows<P, std::uint32_t>, ByPosition> {
  using detail::ListInRows<P, detail::CandidateRows<P, std::uint32_t>, ByPosition>::ListInRows;
  using OfOthers = detail::ListInRows<P, detail::NumberedRows<P, std::uint32_t>, ByPosition>;
};

/// A VerletList for more than 2^32 candidates on one GPU. On a CPU, it is identical to VerletList.
template <class P>
struct LargeVerletList : detail::ListInRows<P, detail::CandidateRows<P, std::uint64_t>> {
  using detail::ListInRows<P, detail::CandidateRows<P, std::uint64_t>>::ListInRows;
  using OfOthers = detail::ListInRows<P, detail::NumberedRows<P, std::uint64_t>>;
};

/// A ReproducibleList for more than 2^32 candidates on one GPU. On a CPU, it is identical to ReproducibleList.
template <class P>
struct LargeReproducibleList : detail::ListInRows<P, detail::CandidateRows<P, std::uint64_t>, ByPosition> {
  using detail::ListInRows<P, detail::CandidateRows<P, std::uint64_t>, ByPosition>::ListInRows;
  using OfOthers = detail::ListInRows<P, detail::NumberedRows<P, std::uint64_t>, ByPosition>;
};

}  // namespace scree
