// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "instances.hpp"
#include "neighbourhood.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace scree {

/// The data that passes work on: a Neighbourhood whose state can be saved and restored.
template <class P, class Search, class Ghosts, class... OfBodies>
class System : public Neighbourhood<P, Search, Ghosts, OfBodies...> {
  using Base = Neighbourhood<P, Search, Ghosts, OfBodies...>;

 public:
  using Base::Base, Base::count, Base::parts, Base::positions_changed, Base::space;
  /// On the default instance.
  System(double smoothing_length, typename Ghosts::Settings const& of_ghosts)
      : System(typename P::space(), smoothing_length, of_ghosts) {}

  /// The state, in addition to the fields, that determines the order of neighbours; for snapshots.
  struct Memory {
    typename Searches<P, Search, count>::Memory searches;
    std::array<int, count> owned = {};  // particles of each body
    std::array<Turnover, count> turnover = {};
    bool stale = true, wrap_due = false;
    int unsettled = 0;
  };
  Memory memory() const {
    Memory memory{searches_.memory(), {}, turnover_, stale_, wrap_due_, unsettled_};
    auto const places = now();
    for (std::size_t k = 0; k < count; ++k) memory.owned[k] = places[k].owned;
    return memory;
  }
  /// The numbers of the particles of each body that belong to this part; empty: all.
  using Kept = std::array<std::vector<int>, count>;
  /// Sets the system to the state of another one with the same fields and all particles of the case: pour(kept) sets
  /// the fields of the owned particles.
  template <class Pour>
  void restore(Memory memory, Pour const& pour) {
    for_each([&]<std::size_t K>(auto& body) {
      if (body.size() != memory.owned[K]) body.resize(memory.owned[K]);
    });
    turnover_ = memory.turnover;
    Kept kept;
    if constexpr (detail::on_parts<Ghosts>) Ghosts::begin_again(ghosts_);
    if constexpr (requires { memory.searches.kept; })
      if (memory.searches.builds > 0) kept = restore_ghosts(memory.searches);
    searches_.restore(space(), memory.searches, parts());
    pour(kept);
    positions_changed();
    stale_ = memory.stale;
    wrap_due_ = memory.wrap_due;
    unsettled_ = memory.unsettled;
    this->end_trial();
  }

 private:
  using Base::bodies_, Base::ghosts_, Base::searches_, Base::stale_, Base::turnover_, Base::unsettled_, Base::wrap_due_;
  using Base::for_each, Base::has_ghosts, Base::now;
  /// Ghosts belong to the positions that the lists were built from, those of the owned particles in `lists`. Adds their
  /// positions to these.
  template <class Lists>
  Kept restore_ghosts(Lists& lists) {
    using namespace fields;
    Kept kept;
    if (!has_ghosts()) return kept;
    for_each([&]<std::size_t K>(auto& body) {
      lists.kept[K].resize(std::size_t(body.size()));
      body.from_host(position, lists.kept[K]);
    });
    if constexpr (detail::on_parts<Ghosts>)
      kept = Ghosts::scatter(ghosts_, bodies_);
    else
      for_each([&]<std::size_t K>(auto& body) { ghosts_[K].create(body); });
    for_each([&]<std::size_t K>(auto& body) {
      lists.owned[K] = body.size();
      lists.kept[K] = values_of(body[position]);
    });
    return kept;
  }
};

}  // namespace scree
