// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "../../../../examples/shear_box/reference/exact.hpp"
#include "../../../../examples/shear_box/reference/finite_volume_1d.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <array>
#include <vector>

namespace scree::test::reference_table_tests {
using namespace shear_box::reference;
using Catch::Matchers::WithinAbs;

// Values found independently of this code (another finite-volume solver, 2000 cells), printed with five digits.
namespace {

struct Row {
  double time;
  std::array<double, 5> C;  // at z = 0.1, 0.3, 0.5, 0.7, 0.9
  double centre_of_small_grains;
  double mean_of_lower_half;
};

constexpr double last_digit = 1.0e-5;

void check(Row const& row, Profile const& profile) {
  INFO("t = " << row.time);
  for (int i = 0; i < 5; ++i) CHECK_THAT(profile(0.1 + 0.2 * i), WithinAbs(row.C[i], last_digit));
  CHECK_THAT(profile.centre_of_small_grains(), WithinAbs(row.centre_of_small_grains, last_digit));
  CHECK_THAT(profile.mean_of_lower_half(), WithinAbs(row.mean_of_lower_half, last_digit));
}

void check_exact(Coefficients coefficients, std::vector<Row> const& rows) {
  ExactSeries const exact(coefficients);
  for (Row const& row : rows) {
    Profile profile{.h = 1.0 / 2000, .values = {}};
    for (int i = 0; i < 2000; ++i) profile.values.push_back(exact(profile.centre(i), row.time));
    check(row, profile);
  }
}

template <class Closure>
void check_finite_volumes(Problem<Closure> const& problem, std::vector<Row> const& rows) {
  std::vector<double> times;
  for (Row const& row : rows) times.push_back(row.time);
  std::vector<Profile> const profiles = solve_1d(problem, times);
  for (std::size_t i = 0; i < rows.size(); ++i) check(rows[i], profiles[i]);
}

std::vector<Row> const a_symmetric = {{20, {.07451, .26168, .5, .73832, .92549}, .67589, .22803},
                                      {40, {.30354, .36924, .5, .63076, .69646}, .53813, .41311},
                                      {60, {.89567, .41420, .5, .58580, .10433}, .40267, .59360},
                                      {80, {.99829, .66403, .5, .33597, .00171}, .30381, .77187},
                                      {120, {1.0, .99987, .5, .00013, .0}, .25133, .97231}};
std::vector<Row> const a_asymmetric = {{20, {.11229, .22775, .39605, .72469, .99537}, .67855, .22217},
                                       {40, {.53525, .28877, .38117, .51538, .77607}, .55286, .40454},
                                       {60, {.86129, .38644, .37443, .45511, .50774}, .42233, .58331},
                                       {80, {.93237, .75235, .40353, .41846, .00142}, .32177, .75770}};
std::vector<Row> const b_symmetric = {{20, {.31731, .36025, .5, .63975, .68269}, .55328, .39496},
                                      {40, {.96091, .56966, .5, .43034, .03909}, .33688, .71413},
                                      {80, {.99999, .99724, .5, .00276, .00001}, .25377, .95313}};
std::vector<Row> const b_asymmetric = {{20, {.45543, .29176, .39606, .55051, .78788}, .56637, .38481},
                                       {40, {.87280, .64609, .42325, .43828, .07856}, .35788, .69479},
                                       {80, {.96618, .92096, .68656, .00127, .00000}, .26690, .91261}};

}  // namespace

TEST_CASE("reference table: symmetric flux, exact series") {
  check_exact(reading_a, a_symmetric);
  check_exact(reading_b, b_symmetric);
}

TEST_CASE("reference table: asymmetric flux, finite volumes") {
  check_finite_volumes(Problem<>{.flux = asymmetric_flux, .closure = {reading_a}}, a_asymmetric);
  check_finite_volumes(Problem<>{.flux = asymmetric_flux, .closure = {reading_b}}, b_asymmetric);
}

}  // namespace scree::test::reference_table_tests
