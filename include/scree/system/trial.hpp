// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "saved_fields.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace scree::detail {

/// The state of a system at the beginning of a trial. The steps of a trial may use neighbour lists that are no longer
/// valid, because lists are checked rarely; if so, the system returns to this state.
template <class P, class Watch>
class Trial {
 public:
  bool under_way = false;
  long failures = 0;                     ///< number of failed trials so far
  bool stale = false, wrap_due = false;  ///< state of the system at the beginning of the trial

  /// The number of particles of a system, including walls, above which a check after each update costs less than a
  /// trial, whose copies need a fifth of the memory.
  static constexpr int most = 1 << 22;

  void begin(AllBodiesRead<P> bodies, Watch&& watch) {
    fields_.resize(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) fields_[k].save(bodies[k].columns());
    history_ = watch.look_rarely();
    under_way = true;
  }
  void undo(AllBodiesRead<P> bodies, Watch&& watch) {
    for (std::size_t k = 0; k < bodies.size(); ++k) fields_[k].restore(bodies[k].columns());
    watch.go_back(history_);
    under_way = false;
    ++failures;
  }

 private:
  std::vector<SavedFields<typename P::space>> fields_;
  typename std::remove_reference_t<Watch>::History history_;
};

}  // namespace scree::detail
