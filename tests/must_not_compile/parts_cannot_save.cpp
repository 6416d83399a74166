// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: does not work yet for a formulation whose case has several parts
#include <scree/distributed/other_parts.hpp>
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Flow : scree::Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = scree::Granular<>;
#ifndef FIXED
  template <class P>
  using ghosts = scree::OtherParts<P>;
#endif
};
scree::Snapshot save(scree::Solver<Flow> const& solver) { return solver.snapshot(); }
