// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <footing_and_wheel/bed.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace footing_and_wheel {
namespace {

TEST_CASE("the wheel has the results of one part on 3 parts") {
  Folder const folder;
  auto const run = [&](int parts) {
    Options o;
    o.numerics.spacing = 0.01, o.numerics.parts = parts;
    o.output = {.duration = 0.05, .interval = 0.01, .frames = 0.05};
    auto const output = folder.path / std::to_string(parts);
    run_in(output, o, simulate<double>);
    return table_in(output / "history.csv") + summary_in(output / "summary.json");
  };
  auto const whole = run(1);
  CHECK(whole.size() > 500);
  CHECK((run(3) == whole));
}

}  // namespace
}  // namespace footing_and_wheel
