// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"

namespace scree::detail {

/// An unnamed formulation with the given choices. Solvers of all formulations with the same choices share their code;
/// the library scree::compiled contains the code for the default choices (granular/solvers.hpp).
template <class Basis, class Search, class Ghosts, class Integrator, class AllBodies, class Motion, class Diagnostics,
          class Carries, class Physics>
struct Choices {
  static constexpr int dim = Basis::dim;
  using real = typename Basis::real;
  using space = typename Basis::space;
  using kernel = typename Basis::kernel;
  template <class>
  using search = Search;
  template <class>
  using ghosts = Ghosts;
  using integrator = Integrator;
  using bodies = AllBodies;
  using motion = Motion;
  using diagnostics = Diagnostics;
  using carries = Carries;
  using physics = Physics;
};

/// The choices of a formulation.
template <class P>
using choices_of = Choices<basis_of<P>, typename P::template search<basis_of<P>>,
                           typename P::template ghosts<basis_of<P>>, typename P::integrator, typename P::bodies,
                           typename P::motion, typename P::diagnostics, typename P::carries, typename P::physics>;

}  // namespace scree::detail
