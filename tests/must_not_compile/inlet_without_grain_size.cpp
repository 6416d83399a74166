// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: particles that are added need a value of each field that passes read and nothing computes
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

// A field that is read, that has no valid zero and that particles do not get when they enter.
struct Size : scree::Scalar<"size", "m"> {};
struct OfSize {
  using reads = scree::Fields<Size>;
  template <class Point>
  SCREE_FN double mean_diameter(Point const& point) const {
    return point[Size{}];
  }
};
struct Models : scree::GranularModels {
  using law = scree::MuOfI<OfSize>;
};
struct Fed : scree::Formulation<2> {
  using physics = scree::Granular<Models>;
  using carries = scree::Fields<scree::Held>;
};

void feed(scree::Solver<Fed>& solver, scree::Inlet<2> const& inlet) {
#ifdef FIXED
  solver.feed(inlet, scree::given(Size{}, 1e-3));
#else
  solver.feed(inlet);
#endif
}
