// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/basis.hpp>
#include <scree/kernels/wendland_c2.hpp>
#include <scree/passes/sums.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree::test::sums_tests {
namespace {

using P = Basis<2, float, WendlandC2, Kokkos::DefaultExecutionSpace>;
struct VolumeAndCube {
  static constexpr int count = 2;
  using reads = Fields<Volume>;
  template <class I>
  SCREE_FN Vec<2, double> operator()(I const& i) const {
    double const V = double(i[fields::volume]);
    return {V, V * V * V};
  }
};
Particles<P, Fields<Position, Volume>> particles(std::vector<float> const& volumes) {
  Particles<P, Fields<Position, Volume>> all(int(volumes.size()));
  all.from_host(fields::volume, volumes);
  return all;
}

}  // namespace

TEST_CASE("sums over particles are exact where their terms are multiples of the unit, in any order") {
  std::vector<float> volumes;
  for (int k = 0; k < 1000; ++k) volumes.push_back(float(k % 7) - 3);
  auto const forwards = sums_over(WholeBody(particles(volumes)), VolumeAndCube{}, "the sum");
  double sum = 0, cubes = 0;
  for (double const V : volumes) sum += V, cubes += V * V * V;
  CHECK(forwards[0] == sum);
  CHECK(forwards[1] == cubes);
  std::vector<float> const backwards(volumes.rbegin(), volumes.rend());
  CHECK(sums_over(WholeBody(particles(backwards)), VolumeAndCube{}, "the sum") == forwards);
}

TEST_CASE("the sum over no particles is 0") {
  CHECK(sums_over(WholeBody(particles({})), VolumeAndCube{}, "the sum") == Vec<2, double>(0, 0));
}

TEST_CASE("a term that is not finite is refused with the name of the sum") {
  for (float const bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    try {
      sums_over(WholeBody(particles({1, 2, bad, 3})), VolumeAndCube{}, "the sum");
      FAIL("accepted");
    } catch (std::runtime_error const& error) {
      CHECK(std::string(error.what()) == "scree: the sum cannot be computed: a value that it reads is not finite");
    }
  }
}

}  // namespace scree::test::sums_tests
