// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a derived field needs a static function of
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

struct Speed : scree::Scalar<"speed", "m/s"> {
  using reads = scree::Fields<scree::Velocity>;
#ifdef FIXED
  template <class I>
  static auto of(I const& i, scree::Resolution const&) {
    return scree::norm(i[scree::fields::velocity]);
  }
#endif
};

void write(scree::BodySeries<scree::Fields<Speed>>& output, scree::Solver<Case>& solver) { output.append(solver); }
