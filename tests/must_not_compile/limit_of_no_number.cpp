// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: needs operator\(\)\(i\) const, which returns a number
#include <scree/solver/solver.hpp>

struct Speed {
  using reads = scree::Fields<scree::Velocity>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    using namespace scree::fields;
#ifdef FIXED
    return scree::norm(i[velocity]);
#else
    return i[velocity];
#endif
  }
};
struct Flies {
  using evolves = scree::Fields<scree::Velocity, scree::Position>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  auto limits(scree::Resolution const& resolution) const {
    return std::tuple(scree::limit("speed", Speed{}, [h = resolution.spacing](double u) { return h / u; }));
  }
};

struct Case : scree::Formulation<2> {
  using physics = Flies;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
