// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/case_file.hpp>
#include <scree/app/list_of_sizes.hpp>
#include <scree/app/species_section.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace scree::test::species_list_tests {
using app::SpeciesList;
namespace {

using Mixture = SpeciesList::Mixture;
SpeciesList const list{.diameters = {3e-3, 1e-3, 2e-3}, .shares = {0.2, 0.5, 0.3}};

struct Options {
  double d_small = 1e-3;
  SpeciesList species;
};
struct Case {
  Options old;
  SpeciesList species;
};
app::Case<Case> read(std::vector<std::string> const& overrides) {
  app::Schema<Case> schema;
  schema.section("old", &Case::old, "Two sizes").add("d_small", &Options::d_small, {.unit = "m", .meaning = "small"});
  app::describe_species(schema, &Case::species, "In any order", {"old.d_small"});
  return app::read_case(schema, "", overrides);
}
std::string errors(std::vector<std::string> const& overrides) {
  try {
    read(overrides);
  } catch (app::CaseError const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("species that are not in a list are absent and have a diameter that is in it") {
  CHECK(list.count() == 3);
  CHECK(list.smallest() == 1);
  CHECK(list.all_diameters() == Mixture(3e-3, 1e-3, 2e-3, 2e-3, 2e-3));
  CHECK((list.mixed() - Mixture(0.2, 0.5, 0.3, 0, 0)).norm() < 1e-15);
  CHECK(SpeciesList().empty());
  SpeciesList const rounded{.diameters = {1e-3, 2e-3, 3e-3}, .shares = {0.3333334, 0.3333333, 0.3333334}};
  CHECK(std::abs(rounded.mixed().sum() - 1) < 1e-15);
  auto const physics = app::ListOfSizes::segregation(list);
  CHECK_NOTHROW(physics.check());
  CHECK(physics.warning().empty());
}

TEST_CASE("layers of a list fill the bed in its order with their shares") {
  CHECK(list.layer(0, 0.1) == Mixture::Unit(0));
  CHECK(list.layer(0.3, 0.6) == Mixture::Unit(1));
  CHECK(list.layer(0.9, 1) == Mixture::Unit(2));
  CHECK((list.layer(0.1, 0.4) - Mixture(1.0 / 3, 2.0 / 3, 0, 0, 0)).norm() < 1e-14);  // across a border
  CHECK((list.layer(0, 1) - list.mixed()).norm() < 1e-14);
  CHECK(list.layer(1, 1.1) == Mixture::Unit(2));  // beyond the bed by rounding
  Mixture sum = Mixture::Zero();
  for (int k = 0; k < 7; ++k) sum += list.layer(k / 7.0, (k + 1) / 7.0) / 7;
  CHECK((sum - list.mixed()).norm() < 1e-14);
}

TEST_CASE("a list of sizes in a case file is a mixture, or one sentence says why not") {
  auto const found = read({"species.diameters=[1e-3, 2e-3]", "species.shares=[0.25, 0.75]"});
  CHECK(found.options.species.count() == 2);
  CHECK(found.notes.empty());
  CHECK(read({}).options.species.empty());
  CHECK(read({"species.diameters=[1e-3, 2e-3]", "species.shares=[0.25, 0.75]", "old.d_small=2e-3"}).notes ==
        std::vector<std::string>{"--set: old.d_small: has no effect while species.diameters is given"});
  CHECK(errors({"species.diameters=[1e-3, 2e-3]", "species.shares=[0.25, 0.7]"}) ==
        "--set: species.shares: they add up to 0.95, not to 1");
  CHECK(errors({"species.diameters=[1e-3, 2e-3]"}) == "default: species.shares: 0 shares for 2 species.diameters");
  CHECK(errors({"species.shares=[1]"}) == "--set: species.shares: 1 shares for 0 species.diameters");
}

}  // namespace scree::test::species_list_tests
