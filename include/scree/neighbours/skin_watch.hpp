// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../core/loop.hpp"
#include "../fields/position_guard.hpp"
#include "neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace scree {
namespace detail {

/// A function for reduce() that finds the largest displacement of the particles of several bodies. Particle numbers
/// continue from one body to the next.
template <class P>
struct LargestDisplacement {
  static constexpr int most = 4;  // largest number of bodies
  using real = typename P::real;
  using value_type = real;
  PositionSpan<P> now[most], then[most];
  int sizes[most], bodies;

  SCREE_FN void init(real& largest) const { largest = 0; }
  SCREE_FN void join(real& largest, real const& other) const { largest = Kokkos::max(largest, other); }
  SCREE_FN void operator()(int i, real& largest) const {
    for (int body = 0; body < bodies; ++body) {
      if (i < sizes[body]) {
        largest = Kokkos::max(largest, displacement(now[body](i), then[body](i)));
        return;
      }
      i -= sizes[body];
    }
  }

 private:
  template <class X>
  SCREE_FN static real displacement(X const& now, X const& then) {
    return or_infinity(norm(value_of(now) - value_of(then)));
  }
};

/// The exception that is thrown if lists were used after particles had moved too far. The caller that requested rare
/// checks must return to an earlier state.
struct ListsOutrun {};

}  // namespace detail

/// A monitor that determines when neighbour lists with a skin, for pairs within and between bodies, must be rebuilt. A
/// SkinWatch stores the positions of the last build. Only owned particles are checked, because ghosts move with them.
///
/// A list is valid until a particle has moved by half the skin since the last build. By default, displacements are
/// measured after every update. On a GPU, each measurement costs a loop over the particles and a synchronisation, so a
/// caller that can return to an earlier state may request rare checks. The interval to the next check is at most 256
/// updates; it is extrapolated from the last two checks, assuming constant acceleration. Between checks, loops that
/// move particles record the first update in which a particle moves too far (PositionGuard). If a list was used after
/// that update, outrun() returns true at the next check, and the caller repeats its work with a check after every
/// update. Lists are built at the same updates with and without rare checks: after the first update that moves a
/// particle too far, or at a regular check that predicts that the lists will soon be invalid. See
/// docs/neighbour_lists.md.
template <class P>
class SkinWatch {
 public:
  using Now = std::vector<Places<P>> const&;  // the places of each body
  using vector = Vec<P::dim, typename P::real>;
  using Kept = Array<P, vector>;
  using Guard = detail::PositionGuard<P>;

  /// Makes a monitor for the lists of a number of bodies, with a skin in m.
  SkinWatch(double skin, std::size_t bodies) : half_skin_(skin / 2), kept_(bodies) { forget_notes(); }

  /// Whether crossed() measures displacements at this update.
  bool looks_now() const { return !rare_looks_ || is_due(); }
  /// Returns the largest displacement of a particle divided by half the skin, or 0 if looks_now() is false. Returns
  /// infinity if there are no lists, or if the lists are for other numbers of particles.
  double crossed(Now now) const;
  /// Whether the lists are valid if `crossed` is the largest result of crossed(). Call this function once after each
  /// change of positions and, if looks_now() is true, call outrun() first.
  bool serves(double crossed);
  /// Stores the positions `now`. Call this function when lists are built from these positions.
  void keep(Now now);
  /// Returns the largest displacement of a particle since the last build, divided by half the skin.
  double crossed_since(Now now) const;

  struct History {
    long updates = 0, last_look = 0, next_look = 1;  ///< counted from the last build
    double crossed_before = 0;                       ///< at the last check
    static constexpr long rarest_look = 256;         // most updates from one check to the next
  };

  /// Whether rare checks are possible but not yet active.
  bool may_look_rarely() const { return may_look_rarely_ && !rare_looks_; }
  /// Activates rare checks until the next build. Returns the history of the lists, for go_back().
  History look_rarely() {
    rare_looks_ = true;
    return history_;
  }
  /// Ends rare checks.
  void look_always() {
    rare_looks_ = false;
    forget_notes();
  }
  /// Whether invalid lists have been used. Call this function after all kernels have ended.
  bool outrun() const { return rare_looks_ && *noted() <= history_.updates; }
  /// Restores the history that look_rarely() returned, for a caller that repeats the steps since then.
  void go_back(History const& history);
  /// Returns the guard for the loops that move particles of a body.
  Guard guard(std::size_t body) const {
    return {kept_[body].x, typename P::real(sq(half_skin_)), noted(), static_cast<int>(history_.updates + 1)};
  }
  /// Returns the positions of a body at the last build.
  Kept const& kept(std::size_t body) const { return kept_[body].x; }
  /// Returns how often lists were built.
  long builds() const { return builds_; }

  /// The state that determines the lists and their lifetime. A run that continues from a snapshot needs this state,
  /// because lists built from the current positions would have a different order of neighbours.
  struct Memory {
    /// Makes the state for a number of bodies.
    explicit Memory(std::size_t bodies) : kept(bodies), owned(bodies) {}
    std::vector<std::vector<vector>> kept;
    std::vector<int> owned;
    long builds = 0;
    History history;
  };
  /// Returns the state that determines the lists and their lifetime, for a snapshot.
  Memory memory() const;
  /// Restores the state from a snapshot.
  void restore(typename P::space const& space, Memory const& memory);

 private:
  bool is_due() const { return history_.updates + 1 >= history_.next_look; }
  // Memory is kept although the number of ghosts changes from build to build, because freeing it waits for all
  // instances.
  static void copy(Kept& kept, Positions<P> const& x);
  // `crossed`, which is 1 when the list becomes invalid, has grown by g in the n updates since the previous check. With
  // constant acceleration from rest, it grows by (k/n)^2 g in k updates from that check, and so reaches 1 after k = n
  // sqrt(1 + (1 - crossed)/g).
  bool about_to_end(double crossed);

  int volatile* noted() const { return reinterpret_cast<int volatile*>(note_.data()); }
  void forget_notes() { *noted() = Guard::none; }

  double half_skin_;
  struct Built {
    Kept x;
    int owned = 0;
  };
  std::vector<Built> kept_;  // the positions of each body at the last build
  long builds_ = 0;
  History history_;
  bool rare_looks_ = false, may_look_rarely_ = false;  // the second: lists exist and were valid when used
  scree::Memory<Kokkos::SharedHostPinnedSpace> note_{"scree::note", sizeof(int)};
};

template <class P>
double SkinWatch<P>::crossed(Now now) const {
  ProfilingRegion const region("scree::skin_watch");
  bool comparable = builds_ > 0;
  for (std::size_t body = 0; body < kept_.size(); ++body)
    comparable = comparable && now[body].owned == kept_[body].owned;
  if (!comparable) return std::numeric_limits<double>::infinity();
  return looks_now() ? crossed_since(now) : 0;
}

template <class P>
bool SkinWatch<P>::serves(double crossed) {
  bool const due = is_due();
  if (looks_now()) forget_notes();
  ++history_.updates;
  // A position that is not finite causes a build, which reports it.
  return crossed < 1 && !(due && about_to_end(crossed));
}

template <class P>
void SkinWatch<P>::keep(Now now) {
  for (std::size_t body = 0; body < kept_.size(); ++body) {
    copy(kept_[body].x, now[body].all);  // waits for all kernels of the bodies, so that none writes a note afterwards
    kept_[body].owned = now[body].owned;
  }
  ++builds_;
  // The lifetime of a list is rarely much shorter than the lifetime of its predecessor.
  history_ = History{.next_look = std::clamp(history_.updates / 4, 1L, History::rarest_look)};
  look_always();
  may_look_rarely_ = true;
}

template <class P>
double SkinWatch<P>::crossed_since(Now now) const {
  using Sweep = detail::LargestDisplacement<P>;
  double crossed = 0;
  for (std::size_t first = 0; first < kept_.size(); first += Sweep::most) {
    Sweep largest{};
    largest.bodies = static_cast<int>(std::min(kept_.size() - first, std::size_t(Sweep::most)));
    int particles = 0;
    for (int k = 0; k < largest.bodies; ++k) {
      std::size_t const body = first + std::size_t(k);
      largest.now[k] = now[body].all, largest.then[k] = kept_[body].x;
      particles += largest.sizes[k] = now[body].owned;
    }
    crossed =
        std::max(crossed, double(reduce(now[0].all.space(), "scree::displacement", particles, largest)) / half_skin_);
  }
  return crossed;
}

template <class P>
void SkinWatch<P>::go_back(History const& history) {
  history_ = history;
  look_always();
  may_look_rarely_ = false;
}

template <class P>
typename SkinWatch<P>::Memory SkinWatch<P>::memory() const {
  Memory memory(kept_.size());
  memory.builds = builds_, memory.history = history_;
  for (std::size_t body = 0; body < kept_.size(); ++body) {
    memory.kept[body] = values_of(kept_[body].x);
    memory.owned[body] = kept_[body].owned;
  }
  return memory;
}

template <class P>
void SkinWatch<P>::restore(typename P::space const& space, Memory const& memory) {
  for (std::size_t body = 0; body < kept_.size(); ++body)
    kept_[body] = {array_of<P>(space, memory.kept[body]), memory.owned[body]};
  builds_ = memory.builds;
  history_ = memory.history;
  look_always();
  may_look_rarely_ = builds_ > 0;
}

template <class P>
void SkinWatch<P>::copy(Kept& kept, Positions<P> const& x) {
  std::size_t const n = std::size_t(x.size());
  if (kept.memory().size() < n * sizeof(*x.data()))
    kept = Kept(x.space(), "scree::kept_positions", n + std::min(n / 8, std::size_t(most_particles) - n));
  kept = {x.space(), kept.memory(), x.size()};
  copy_array(kept, x);
}

template <class P>
bool SkinWatch<P>::about_to_end(double crossed) {
  double const n = double(history_.updates - history_.last_look), growth = crossed - history_.crossed_before;
  double const updates = n * (std::sqrt(1 + (1 - crossed) / growth) - 1);
  long const to_next_look =
      updates >= 1 ? static_cast<long>(std::min({updates, 2 * n, double(History::rarest_look)})) : 1;
  history_ = {history_.updates, history_.updates, history_.updates + to_next_look, crossed};
  return updates + 1 < double(history_.updates) / 16;
}

}  // namespace scree
