// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: must return a value, not an expression of Eigen
#include <scree/io/body_series.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Velocity>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

struct HalfVelocity : scree::Vector<"half velocity", "m/s"> {
  using reads = scree::Fields<scree::Velocity>;
  template <class I>
  static auto of(I const& i, scree::Resolution const&) {
    using namespace scree::fields;
#ifdef FIXED
    return (i[velocity] / 2).eval();
#else
    return i[velocity] / 2;  // refers to the destroyed record
#endif
  }
};

void write(scree::BodySeries<scree::Fields<HalfVelocity>>& output, scree::Solver<Case>& solver) {
  output.append(solver);
}
