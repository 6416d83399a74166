// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the law in TensionCutoff needs a function shear_strength
#include <scree/granular/granular.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/laws/tension_cutoff.hpp>

struct Rubber {
  using reads = scree::Fields<>;
  using history = scree::Fields<>;
  scree::Elastic elastic = {};
  double density() const { return 1000; }
  double bulk_modulus() const { return 1e6; }
  double sound_speed() const { return 30; }
  template <class Real, class Point>
  SCREE_FN scree::StressTensor<Real> stress_rate(scree::StressTensor<Real> const& sigma, scree::Mat<3, Real> const& L,
                                                 Point const& point) const {
    return elastic.stress_rate(sigma, L, point);
  }
#ifdef FIXED
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real, Point const&) const {
    return 1e3;
  }
#endif
  template <class Real, class Point, class History>
  SCREE_FN scree::StressTensor<Real> admissible(scree::StressTensor<Real> const& trial, Point const&, History&&) const {
    return trial;
  }
};

auto admissible(scree::TensionCutoff<Rubber> const& law, scree::StressTensor<double> const& trial) {
  scree::NoHistory none;
  return law.admissible(trial, none, none);
}
