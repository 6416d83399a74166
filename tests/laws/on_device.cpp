// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "hochstetten.hpp"
#include "in_section.hpp"
#include "random_stresses.hpp"

#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/mu_of_i.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>

#include <support/points.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <functional>

// Laws give the same results on the device as on the host: the other tests of this folder run on the host.
namespace scree::test::on_device_tests {

template <class Real>
struct PointOfSand : Point<Real> {
  using Point<Real>::operator[];
  SCREE_FN Real operator[](VoidRatio) const { return Real(0.7); }
};

/// One update of stresses at rest, by the law's own rate and projection.
template <class Law, class Real>
struct UpdateStress {
  using Tensor = StressTensor<Real>;
  Law law;
  SCREE_FN Tensor operator()(Tensor const& sigma) const {
    Tensor L = Tensor::Zero();
    L(0, 1) = Real(30);
    L(1, 2) = Real(-10);
    L(2, 2) = Real(-2);
    Point<Real> memory;
    PointOfSand<Real> const old{{Real(25), Real(0.4), Real(1e-4)}};
    return law.admissible(Tensor(sigma + Real(1e-4) * law.stress_rate(sigma, L, old)), old, memory);
  }
};
template <class P, class Law>
struct UpdateAll {
  ArraySpan<P, StressTensor<typename P::real>> stresses;
  UpdateStress<Law, typename P::real> update;
  SCREE_FN void operator()(int i) const { stresses(i) = update(value_of(stresses(i))); }
};

namespace {

/// Starts from random stresses as `prepared` returns them. `accuracy` is relative.
template <class P, class Law, class Prepared = std::identity>
void check_on_device(Law const& law, double accuracy = ulps<P>(100), Prepared const& prepared = {}) {
  using Real = typename P::real;
  RandomStresses<3, Real> random;
  std::vector<StressTensor<Real>> start;
  for (int n = 0; n < 200; ++n) start.push_back(prepared(random.next()));
  auto const stresses = array_of<P>(start);
  for_each_index(typename P::space(), "scree::test::update", 0, stresses.size(), UpdateAll<P, Law>{stresses, {law}});
  auto const end = values_of(stresses);
  for (std::size_t n = 0; n < 200; ++n) {
    StressTensor<Real> const expected = UpdateStress<Law, Real>{law}(start[n]);
    REQUIRE(expected.allFinite());
    // The device rounds differently: it contracts products and sums.
    REQUIRE((end[n] - expected).norm() <= accuracy * (start[n].norm() + expected.norm() + 1000));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("laws give the same stress on the device", "", float, double) {
  using P = Policy<3, TestType, Kokkos::DefaultExecutionSpace>;
  MuOfI<BidisperseGrains> const granular{.elastic = soft(), .grains = {2.5e-4, 5e-4}};
  DruckerPrager const soil{soft(), plane_strain_cone({0.5, 20, 0.2})};
  check_on_device<P>(VolumeMemory<MuOfI<BidisperseGrains>>{granular});
  check_on_device<P>(RisingMuOfI<BidisperseGrains>{granular, 0.05});
  check_on_device<P>(InSection<VolumeMemory<MuOfI<BidisperseGrains>>>{{granular}});
  check_on_device<P>(TensionCutoff<DruckerPrager>{soil, 5});
  // The angle of a deviator has half of the digits where two principal stresses coincide.
  check_on_device<P>(hochstetten(), std::sqrt(ulps<P>(1)), [](StressTensor<TestType> const& sigma) {
    return hochstetten().admissible(sigma, PointOfSand<TestType>{}, NoHistory{});
  });
}

}  // namespace scree::test::on_device_tests
