// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "yardstick.hpp"

// Rows of the motion pass: by the library, and by hand as its reference.
namespace scree::bench {

/// Data of a row by hand, made from the library's body; its sums are compared with those of the body once.
template <class P>
struct CheckedMotion {
  MotionByHand<P> motion;
  Kokkos::View<int*, memory_of<P>> candidates;  // for groups of lanes
  double pairs, error;
};

/// skin: of the list; lanes: of a warp that share a particle in plain CUDA, 0 for plain Kokkos.
struct ByHand {
  double skin;
  int lanes;
};

template <class P>
void run([[maybe_unused]] ByHand const& how, CheckedMotion<P> const& state) {
#ifdef KOKKOS_ENABLE_CUDA
  if (how.lanes == 1) return run_cuda<1>(state.motion, state.candidates);
  if (how.lanes == 4) return run_cuda<4>(state.motion, state.candidates);
  if (how.lanes == 8) return run_cuda<8>(state.motion, state.candidates);
#endif
  by_hand::run(state.motion);
}

template <class P>
CheckedMotion<P> checked_motion(ByHand const& how, int particles, double smoothing) {
  auto const& cloud = cloud_of<P::dim>(particles, smoothing);
  auto const sum = motion_sum<P>(cloud);
  CheckedMotion<P> state{motion_by_hand<P>(cloud, sum, how.skin), {}, sum.pairs, 0};
#ifdef KOKKOS_ENABLE_CUDA
  if (how.lanes > 0) state.candidates = by_hand::interleaved(state.motion.list, how.lanes);
#endif
  sum.run();
  run(how, state);
  Kokkos::fence();
  state.error = disagreement<P>(sum, state.motion);
  return state;
}

template <class P>
void add_by_hand_row(std::string const& name, ByHand const& how, int particles, double smoothing, int batch) {
  add_row(name, [=](benchmark::State& state) {
    auto& checked = kept(name, [&] { return checked_motion<P>(how, particles, smoothing); });
    if (!(checked.error < tolerated_disagreement<P>())) {
      state.SkipWithError(fmt::format("yardstick and library disagree by {:.1e}", checked.error).c_str());
      return;
    }
    time(state, batch, [&] { run(how, checked); });
    count_pairs(state, double(checked.motion.particles.extent(0)), checked.pairs);
  });
}

template <class P>
void add_motion_rows(int particles, double smoothing, int batch, std::string const& ending) {
  auto const name = [&](std::string const& who) {
    return fmt::format("pairs/motion/{}/{}/h:{}/particles:{}{}", who, basis_name<P>(), smoothing, particles, ending);
  };
  add_row(name("library"), [=, row = name("library")](benchmark::State& state) {
    auto& sum = kept(row, [&] { return motion_sum<P>(cloud_of<P::dim>(particles, smoothing)); });
    time(state, batch, [&] { sum.run(); });
    count_pairs(state, sum.body.size(), sum.pairs);
  });
  add_by_hand_row<P>(name("by_hand"), {MotionOptions::skin, 0}, particles, smoothing, batch);
  add_by_hand_row<P>(name("by_hand_tight"), {0, 0}, particles, smoothing, batch);
#ifdef KOKKOS_ENABLE_CUDA
  for (int const lanes : {1, 4, 8})
    add_by_hand_row<P>(name(fmt::format("by_hand_cuda_{}", lanes)), {MotionOptions::skin, lanes}, particles, smoothing,
                       batch);
#endif
}

template <class P>
int add_motion_rows() {
  for (double const smoothing : smoothings<P>())
    for (int const particles : sizes<P>()) {
      add_motion_rows<P>(particles, smoothing, together, "");
      if (together > alone && particles == small_sizes().front())
        add_motion_rows<P>(particles, smoothing, alone, "/alone");
    }
  return 0;
}

}  // namespace scree::bench
