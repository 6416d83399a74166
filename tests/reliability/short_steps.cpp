// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R19: an extreme state in which steps become too short for the run to end.
#include "tally.hpp"

#include <support/granular_box.hpp>

#include <catch2/catch_template_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::test::short_steps_tests {
using namespace fields;

TEMPLATE_TEST_CASE("a run with a blow-up in it stops soon and says why", "[R19]", double, float) {
  Tally tally("R19");
  tally.note("a stress far beyond any load in one particle");
  std::mt19937 generator(1);
  double const most = std::is_same_v<TestType, float> ? 36 : 300;
  constexpr std::array reasons{" is not finite after step ", " limit", "outside the validity of the model"};
  long latest = 0;
  for (int k = 0; k < attempts(4, 40); ++k) {
    auto solver = granular_box::turning<TestType>();
    granular_box::stepped(solver, 5);
    auto const particle = std::size_t(random_below(generator, solver.material().size()));
    double const exponent = 25 + (most - 25) * random_below(generator, 1000) / 1000;
    auto stresses = solver.material().to_host(stress);
    stresses[particle][0] = -TestType(std::pow(10, exponent));
    std::size_t next = 0;
    solver.set(stress, stresses, [&](auto const&) { return stresses[next++]; });
    std::string report;
    try {
      solver.run(1, {}, [](auto const& s) { return s.steps() > 5000; });
    } catch (std::exception const& error) {
      report = error.what();
    }
    latest = std::max(latest, solver.steps());
    bool const explained = report.starts_with("scree: ") && std::ranges::any_of(reasons, [&](char const* reason) {
                             return report.find(reason) != std::string::npos;
                           });
    tally.count(explained ? "" : "1e" + std::to_string(exponent) + " Pa: " + (report.empty() ? "goes on" : report));
  }
  tally.note("a stress far beyond any load in one particle, stopped before step " + std::to_string(latest + 1));
}

}  // namespace scree::test::short_steps_tests
