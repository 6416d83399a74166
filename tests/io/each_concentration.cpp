// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/each_concentration.hpp>
#include <scree/io/point_data_of.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <variant>
#include <vector>

namespace scree::test::each_concentration_tests {

TEMPLATE_LIST_TEST_CASE("each species of a mixture is an array of its own", "", Policies) {
  using P = TestType;
  using Real = typename P::real;
  using namespace fields;
  Bed<P::dim> const bed{lattice<P::dim>(0.25), {}};
  auto solver = solver_of<Formulated<P, SpeciesSegregation<ConstantSpecies<3>>>>(bed, 0.25, {});
  solver.set(concentrations<3>, [](auto const& x) {
    Real const z = x[P::dim - 1];
    return Vec<3, Real>(z / 2, z / 4, 1 - z * 3 / 4);
  });
  auto const data = point_data_of(solver, EachConcentration<3>{});
  auto const x = solver.material().to_host(position);
  REQUIRE(data.arrays.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(data.arrays[k].name == "concentration_" + std::string(1, char('1' + k)));
    CHECK(data.arrays[k].unit == "1");
    auto const& values = std::get<std::vector<Real>>(data.arrays[k].values);
    REQUIRE(values.size() == x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      Real const z = x[i][P::dim - 1];
      CHECK(values[i] == Vec<3, Real>(z / 2, z / 4, 1 - z * 3 / 4)[int(k)]);
    }
  }
}

}  // namespace scree::test::each_concentration_tests
