// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../core/setting.hpp"
#include "../fields/bodies.hpp"
#include "../formulation/choices.hpp"
#include "../rigid/settings.hpp"
#include "../system/periodic.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace scree {
namespace detail {

struct NoRanks {};
/// The type of the member `ranks` of SolverSettings.
template <class P>
struct ranks_of_case {
  using type = NoRanks;
};
template <class P>
requires DividesCase<typename P::template ghosts<basis_of<P>>>
struct ranks_of_case<P> {
  using type = typename P::template ghosts<basis_of<P>>::Ranks;
};

}  // namespace detail

/// Prints a line to stderr.
[[gnu::cold]] inline void print_warning(std::string const& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

/// The input of a solver except its particles.
template <class P>
struct SolverSettings {
  double spacing = 0;                        ///< initial distance between particles, m
  double smoothing = 1.5;                    ///< smoothing length / spacing, 1.1 to 3; walls have `2 * smoothing` rows
  typename P::physics physics = {};          ///< the physics model with its law and parameters
  typename P::motion motion = {};            ///< the prescribed motion of the walls
  typename P::diagnostics diagnostics = {};  ///< the passes of update_diagnostics(), for output
  /// The rigid bodies, for a formulation with a body that derives from RigidBody.
  std::conditional_t<detail::has_rigid_bodies<typename P::bodies>, RigidBodies<P::dim>, NoRigidBodies> rigid = {};
  std::vector<Period> periods = {};  ///< directions in which the domain is periodic
  /// The number of steps from one sorting of the material to the next; 0: never. As particles mix, neighbours end up
  /// far apart in memory, which costs time. Sorting changes the order of the particles in all arrays; `identity`
  /// identifies them.
  int sort_period = 0;
  /// The fraction of the material that may be lost before a run stops, -; 1: all. Particles are lost if they are more
  /// than a support outside the box around the walls and the positions given to the material; the box is open at the
  /// top and along periods.
  double lost_share = 1e-3;
  /// Whether the first step is rejected if the particle positions are certainly wrong, see check_start().
  bool start_checks = true;
  /// The function that receives the text of each warning; a warning does not stop the run. An empty function discards
  /// all warnings.
  std::function<void(std::string const&)> warn = print_warning;
  /// The ranks of the case, for a formulation whose case may have several ranks (distributed/other_ranks.hpp).
  typename detail::ranks_of_case<P>::type ranks = {};

  /// Returns these settings. Throws std::invalid_argument if one is out of range.
  SolverSettings const& checked() const {
    check_setting(spacing > 0 && std::isfinite(spacing), "spacing (m)", spacing, "above 0");
    check_setting(smoothing >= 1.1 && smoothing <= 3, "smoothing (h/spacing)", smoothing, "from 1.1 to 3");
    check_setting(lost_share >= 0, "lost_share (-)", lost_share, "0 or more");
    check_setting(sort_period >= 0, "sort_period (steps)", sort_period, "0 or more");
    check_settings_of(motion);
    check_settings_of(diagnostics);
    check_settings_of(rigid);
    return *this;
  }
  /// Returns the same settings for a formulation with the same choices under another name.
  template <class Q>
  requires std::is_same_v<detail::choices_of<P>, detail::choices_of<Q>>
  operator SolverSettings<Q>() const {
    return {spacing, smoothing,   physics,    motion,       diagnostics, rigid,
            periods, sort_period, lost_share, start_checks, warn,        ranks};
  }
};

namespace detail {
/// Returns the settings of the ghost particles of a system.
template <class P>
auto ghost_settings(SolverSettings<P> const& settings) {
  using Ghosts = typename P::template ghosts<basis_of<P>>;
  if constexpr (DividesCase<Ghosts>)
    return typename Ghosts::Settings(settings.ranks, settings.periods);
  else
    return settings.periods;
}
}  // namespace detail

}  // namespace scree
