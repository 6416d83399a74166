// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/point_data_of.hpp>

#include <support/granular_box.hpp>
#include <support/listener.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// The parts of a run as profilers see them.
namespace scree::test::regions_tests {
using namespace fields;

TEST_CASE("every loop of a run lies in a named region of the profile") {
  auto solver = granular_box::turning();
  Listener const listener;
  granular_box::stepped(solver, 30);
  point_data_of(solver, Fields<Velocity, Stress>{});
  auto const snapshot = solver.snapshot();
  solver.restore(snapshot);
  solver.check_validity();
  CHECK(listener.loops_outside() == std::set<std::string>());
  CHECK(listener.all_closed());
  for (char const* region : {"scree::step", "scree::rates", "scree::update", "scree::filters", "scree::survey",
                             "scree::skin_watch", "scree::cell_list", "scree::verlet_list", "scree::transport",
                             "scree::point_data", "scree::snapshot", "scree::restore"}) {
    INFO(region);
    CHECK(listener.regions().count(region) == 1);
  }
}

TEST_CASE("an error closes the regions of the profile") {
  auto solver = granular_box::turning();
  solver.set(velocity, [](auto const&) { return Vec<2, double>(std::nan(""), 0); });
  Listener const listener;
  CHECK_THROWS_AS(granular_box::stepped(solver, 3), std::runtime_error);
  CHECK(listener.all_closed());
}

}  // namespace scree::test::regions_tests
