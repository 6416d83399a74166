// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/each_concentration.hpp>
#include <scree/io/in_space.hpp>

#include <catch2/catch_test_macros.hpp>

#include <string_view>
#include <type_traits>
#include <vector>

// Files with these arrays are compared in tests/examples/on_ranks.
namespace scree::test::each_concentration_tests {
namespace {

template <class Real>
struct Particle {
  Vec<3, Real> mixture;
  Vec<3, Real> const& operator[](Concentrations<3>) const { return mixture; }
};
template <class List>
struct Each;
template <class... Fs>
struct Each<Fields<Fs...>> {
  static_assert((DerivedField<Fs> && ...) && ((components_in_space<Fs> == 1) && ...));
  template <class Real>
  static std::vector<Real> of(Particle<Real> const& particle) {
    static_assert((std::is_same_v<decltype(Fs::of(particle, Resolution{})), Real> && ...));
    return {Fs::of(particle, Resolution{})...};
  }
  static std::vector<std::string_view> names() { return {Fs::name...}; }
};

}  // namespace

TEST_CASE("each species of a mixture is a field of its own for output") {
  using All = Each<EachConcentration<3>>;
  CHECK(All::names() == std::vector<std::string_view>{"concentration 1", "concentration 2", "concentration 3"});
  CHECK(All::of(Particle<double>{{0.5, 0.2, 0.3}}) == std::vector<double>{0.5, 0.2, 0.3});
  CHECK(All::of(Particle<float>{{0.5F, 0.125F, 0.375F}}) == std::vector<float>{0.5F, 0.125F, 0.375F});
  CHECK(ConcentrationOf<3, 2>::unit == "1");
}

}  // namespace scree::test::each_concentration_tests
