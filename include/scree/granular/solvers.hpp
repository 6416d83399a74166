// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/choices.hpp"
#include "../formulation/formulation.hpp"
#include "../passes/over_lists.hpp"
#include "../solver/engine.hpp"
#include "granular.hpp"

// The solvers that are compiled in the library scree::compiled: solvers of Granular<> with the default choices of a
// formulation. src/compiled/solvers.cpp instantiates them from this list.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {
template <class P>
struct DefaultFormulation : Formulation<P::dim, typename P::real> {
  using physics = Granular<>;
};
template <class P>
using DefaultChoices = choices_of<DefaultFormulation<P>>;
template <class P>
using DefaultState = SolverState<DefaultChoices<P>>;
}  // namespace scree::detail

#define SCREE_SOLVERS(INSTANCE, P)                                                                                  \
  namespace scree::detail {                                                                                         \
  INSTANCE DefaultState<P> state_at_start(P::space const&, ParticlesAtStart<DefaultChoices<P>> const&,              \
                                          SolverSettings<DefaultChoices<P>> const&);                                \
  INSTANCE void update_rates(DefaultState<P>&, bool);                                                               \
  INSTANCE double take_step(DefaultState<P>&, double);                                                              \
  INSTANCE void check_step(DefaultState<P>&);                                                                       \
  INSTANCE void check_start_once(DefaultState<P>&);                                                                 \
  INSTANCE std::vector<TimeStepLimit> limits_now(DefaultState<P> const&);                                           \
  INSTANCE void set_motion(DefaultState<P>&, AtRest const&);                                                        \
  INSTANCE Snapshot snapshot_of_state(DefaultState<P> const&);                                                      \
  INSTANCE void restore_state(DefaultState<P>&, Snapshot const&, std::string const&, std::function<void()> const&); \
  }
// Single precision is meant for GPUs: without CUDA, programs compile single-precision solvers themselves.
#ifdef KOKKOS_ENABLE_CUDA
#define SCREE_FOR_DEFAULT_SOLVERS SCREE_FOR_DEFAULT_BASES
#else
#define SCREE_FOR_DEFAULT_SOLVERS(INSTANCES) INSTANCES(scree::detail::DefaultIn2D) INSTANCES(scree::detail::DefaultIn3D)
#endif
#define SCREE_SOLVERS_ELSEWHERE(P) SCREE_SOLVERS(extern template, P)
SCREE_FOR_DEFAULT_SOLVERS(SCREE_SOLVERS_ELSEWHERE)
#undef SCREE_SOLVERS_ELSEWHERE
#endif
