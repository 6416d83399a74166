// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

// The least formulation: a case includes this in its code, where it needs one.
struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};
struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};
using S = scree::Solver<Case>;
using Points = std::vector<scree::Vec<2, double>>;
