// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "refused.hpp"
#include "solver.hpp"

#include <string>
#include <vector>

namespace scree {

/// The solver of a faulty formulation. The compiler reports the fault, and little about the rest of the program.
template <class P>
requires(!detail::explain_formulation<P>()) class Solver<P> : public Solver<detail::StandIn<P>> {
 public:
  using Observers = std::vector<Observer<Solver>>;
  explicit Solver(...);
  void check_start();
  template <class... Others>
  void run(double, Observers const& = {}, Others const&...) {}
  template <class Body = Material, class... Any>
  void set(Any const&...) {}
  Snapshot snapshot() const;
  void restore(Snapshot const&);
};

}  // namespace scree
