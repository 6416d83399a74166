// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results_of.hpp"

#include <silo/silo.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

namespace silo {
namespace {

TEST_CASE("the silo has the results of one part on 3 parts while grains leave it") {
  Folder const folder;
  auto const run = [&](int parts) {
    Options o;
    o.geometry = {.width = 0.06, .height = 0.06, .outlet = 0.03};
    o.numerics.spacing = 0.004, o.numerics.parts = parts;
    o.output = {.opens = 0.02, .duration = 0.2, .interval = 0.01, .frames = 0.05};
    auto const output = folder.path / std::to_string(parts);
    run_in(output, o, simulate<2>);
    return results_of(output, "history.csv", "particles.vtkhdf", "summary.json");
  };
  auto const whole = run(1);
  CHECK(whole.size() > 20'000);
  CHECK(whole.find("\"removed\" : 0,") == std::string::npos);
  CHECK((run(3) == whole));
}

}  // namespace
}  // namespace silo
