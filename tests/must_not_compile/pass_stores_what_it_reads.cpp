// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a pass must not store a field that it reads of neighbours
#include <scree/passes/run_passes.hpp>
#include <scree/terms/shepard.hpp>

// The mean must not replace the field itself while neighbours still read it.
struct Mean {
  using reads = scree::Fields<>;
#ifdef FIXED
  using writes = scree::Fields<scree::Smoothed<scree::Concentration>>;
#else
  using writes = scree::Fields<scree::Concentration>;
#endif
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[writes_first(writes{})] = total[scree::WeightedSum<scree::Concentration>{}] / total[scree::fields::weight];
  }
  template <class F>
  SCREE_FN static F writes_first(scree::Fields<F>) {
    return {};
  }
};

auto const pass = scree::pair_pass_then<scree::Material>(
    "mean", Mean{}, scree::over<scree::Material>(scree::ShepardSums<scree::Concentration>{}));
