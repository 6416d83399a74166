// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <scree/core/setting.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>

#include <limits>

namespace scree::test::model_parameters_tests {
using namespace scree;
using namespace scree::app;

namespace {

struct Spring {
  double stiffness = 4;
  double damping = 0.1;
  int turns = 7;

  static constexpr auto parameters() {
    return std::array{parameter("stiffness", &Spring::stiffness, "N/m", "force over length", allowed::above(0)),
                      parameter("damping", &Spring::damping, "1", "share of the critical one", allowed::between(-1, 1)),
                      parameter("turns", &Spring::turns, "1", "how many", allowed::from_to(1, 100))};
  }
};

struct Carriage {
  double k = 5;
  std::optional<double> loss = {};
  int windings = 3;
};
struct Options {
  Carriage carriage;
  Spring spring;
};

Schema<Options> schema() {
  Schema<Options> all;
  all.section("carriage", &Options::carriage, "Renamed, narrower, with other defaults")
      .add("k", &Carriage::k, parameter_of<&Spring::stiffness>.within(1, 10))
      .add("loss", &Carriage::loss, parameter_of<&Spring::damping>, "by the oil")
      .add("windings", &Carriage::windings, parameter_of<&Spring::turns>);
  all.section("spring", &Options::spring, "As the model has it").add_parameters();
  return all;
}

std::string error(std::string const& override) {
  try {
    read_case(schema(), "", std::vector{override});
  } catch (CaseError const& problem) {
    return problem.lines.at(0);
  }
  return "";
}

}  // namespace

TEST_CASE("an option for a parameter of a model has its unit, range and meaning") {
  CHECK(option_table(schema()) ==
        R"(| key               | unit | default    | allowed                | meaning                   |
| ----------------- | ---- | ---------- | ---------------------- | ------------------------- |
| carriage.k        | N/m  | 5          | a number in [1, 10]    | force over length         |
| carriage.loss     | 1    | by the oil | a number in (-1, 1)    | share of the critical one |
| carriage.windings | 1    | 3          | an integer in [1, 100] | how many                  |
| spring.stiffness  | N/m  | 4          | a number > 0           | force over length         |
| spring.damping    | 1    | 0.1        | a number in (-1, 1)    | share of the critical one |
| spring.turns      | 1    | 7          | an integer in [1, 100] | how many                  |
)");
}

TEST_CASE("a value outside of the range of the model is refused with key, value and range") {
  CHECK(error("carriage.k=11") == "--set: carriage.k: 11 is out of range; allowed: a number in [1, 10] N/m");
  CHECK(error("spring.stiffness=0") == "--set: spring.stiffness: 0 is out of range; allowed: a number > 0 N/m");
  CHECK(error("spring.stiffness=11").empty());
  CHECK(error("carriage.loss=1") == "--set: carriage.loss: 1 is out of range; allowed: a number in (-1, 1)");
  CHECK(error("spring.turns=0") == "--set: spring.turns: 0 is out of range; allowed: an integer in [1, 100]");
}

TEST_CASE("the check of a model refuses what its options refuse") {
  CHECK_NOTHROW(check_settings_of(Spring{}));
  CHECK_THROWS_WITH(check_settings_of(Spring{.stiffness = 0}), "scree: stiffness (N/m) must be above 0, not 0");
  CHECK_THROWS_WITH(check_settings_of(Spring{.damping = 1}), "scree: damping (-) must be above -1 and below 1, not 1");
  CHECK_THROWS_WITH(check_settings_of(Spring{.turns = 0}), "scree: turns (-) must be 1 to 100, not 0");
}

TEST_CASE("a range includes narrower ranges and no wider ones") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK(allowed::above(0).includes({1e-3, 1}));
  CHECK(allowed::above(0).includes(allowed::above(0)));
  CHECK(allowed::above(0).includes({1, inf}));
  CHECK_FALSE(allowed::above(0).includes({0, 1}));
  CHECK_FALSE(allowed::above(0, 1).includes({0.5, 1.01}));
  CHECK(allowed::from_to(0, 1).includes(allowed::between(0, 1)));
  CHECK_FALSE(allowed::between(0, 1).includes({0.5, 1}));
  CHECK_FALSE(allowed::at_least(0).includes({-1e-300, 1}));
  CHECK(allowed::finite().includes({-inf, inf}));
}

}  // namespace scree::test::model_parameters_tests
