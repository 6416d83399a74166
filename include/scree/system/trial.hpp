// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "saved_fields.hpp"

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace scree::detail {

/// Steps that may have used neighbour lists which were no longer valid, because these are checked rarely: the state at
/// their beginning, to which a system returns if that turns out to be so.
template <class Space, class Watch, std::size_t Count>
class Trial {
 public:
  bool under_way = false;
  long failures = 0;                     ///< so far
  bool stale = false, wrap_due = false;  ///< of the system at the beginning

  /// Particles of a rank, with its walls, above which a check after each update costs less than a trial, whose copies
  /// need a fifth of the memory.
  static constexpr int most = 1 << 22;

  template <class... Bodies>
  void begin(std::tuple<Bodies...> const& bodies, Watch&& watch) {
    for_each(bodies, [](auto& fields, auto const& body) { fields.save(body.columns()); });
    history_ = watch.look_rarely();
    under_way = true;
  }
  template <class... Bodies>
  void undo(std::tuple<Bodies...> const& bodies, Watch&& watch) {
    for_each(bodies, [](auto& fields, auto const& body) { fields.restore(body.columns()); });
    watch.go_back(history_);
    under_way = false;
    ++failures;
  }

 private:
  template <class... Bodies, class Visit>
  void for_each(std::tuple<Bodies...> const& bodies, Visit const& visit) {
    [&]<std::size_t... K>(std::index_sequence<K...>) { (visit(fields_[K], std::get<K>(bodies)), ...); }
    (std::index_sequence_for<Bodies...>{});
  }
  std::array<SavedFields<Space>, Count> fields_;
  typename std::remove_reference_t<Watch>::History history_;
};

}  // namespace scree::detail
