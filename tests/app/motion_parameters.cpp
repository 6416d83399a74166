// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation_about.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::motion_parameters_tests {
using namespace scree;

namespace {

struct Options {
  RotationAbout::Parameters blade = {.rate = 2};
  Oscillation<2> floor = {.amplitude = {0.01, 0}, .period = 0.3};
};

app::Schema<Options> schema() {
  app::Schema<Options> all;
  all.section("blade", &Options::blade, "It turns").add_parameters();
  all.section("floor", &Options::floor, "It shakes").add_parameters();
  return all;
}

std::string error(std::string const& override) {
  try {
    app::read_case(schema(), "", std::vector{override});
  } catch (app::CaseError const& problem) {
    return problem.lines.at(0);
  }
  return "";
}

}  // namespace

TEST_CASE("a case names a motion by its parameters, vectors as arrays") {
  std::vector<std::string> const words = {"blade.axis=[0, 3, 0]", "blade.centre=[0.1, 0, -0.2]",
                                          "floor.amplitude=[0, 0.02]"};
  Options const o = app::read_case(schema(), "", words).options;
  using X = Vec<3, double>;
  X const x(1, 2, 3);
  CHECK(RotationAbout(o.blade).displaced(x, 0, 1) == RotationAbout(2, {0, 1, 0}, {0.1, 0, -0.2}).displaced(x, 0, 1));
  CHECK(o.floor.amplitude == Vec<2, double>(0, 0.02));
  CHECK(o.floor.period == 0.3);
}

TEST_CASE("the table of options has the parameters of a motion with unit, default and number of components") {
  CHECK(
      app::option_table(schema()) ==
      R"(| key                  | unit  | default   | allowed               | meaning                                                |
| -------------------- | ----- | --------- | --------------------- | ------------------------------------------------------ |
| blade.rate           | rad/s | 2         | a number              | angular velocity                                       |
| blade.axis           | 1     | [0, 0, 1] | an array of 3 numbers | direction of the axis, of any length above 0           |
| blade.centre         | m     | [0, 0, 0] | an array of 3 numbers | a point of the axis                                    |
| blade.angle_per_step | rad   | 0.05      | a number > 0          | largest angle in one step                              |
| floor.amplitude      | m     | [0.01, 0] | an array of 2 numbers | largest displacement, with its direction               |
| floor.period         | s     | 0.3       | a number > 0          | period                                                 |
| floor.phase          | rad   | 0         | a number              | phase at time zero; pi/2: at rest at the turning point |
| floor.angle_per_step | rad   | 0.05      | a number > 0          | largest angle in one step                              |
)");
}

TEST_CASE("an array of another length and a component that is no number are refused") {
  CHECK(error("blade.axis=[0, 1]") ==
        "--set: blade.axis: an array of 2 where one of 3 is expected; allowed: an array of 3 numbers");
  CHECK(error("floor.amplitude=[0, inf]") ==
        "--set: floor.amplitude: inf is not a finite number; allowed: an array of 2 numbers m");
  CHECK(error("floor.amplitude=0.1") ==
        "--set: floor.amplitude: a number where an array of numbers is expected; allowed: an array of 2 numbers m");
  CHECK(error("blade.angle_per_step=0") == "--set: blade.angle_per_step: 0 is out of range; allowed: a number > 0 rad");
}

}  // namespace scree::test::motion_parameters_tests
