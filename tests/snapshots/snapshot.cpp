// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/kernels/wendland_c4.hpp>
#include <scree/snapshots/snapshot_of.hpp>

#include <support/moving_particles.hpp>
#include <support/two_bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::snapshot_tests {
namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

/// A run that is stopped after some steps, continues in another system, and ends after 37.
template <class P, template <class...> class Search>
Snapshot resumed(bool periodic, int stop) {
  auto first = moving_system<P, Search>(periodic);
  advance(first, stop);
  auto second = moving_system<P, Search>(periodic);
  restore_into(second, snapshot_of(first));
  advance(second, 37 - stop);
  return snapshot_of(second);
}
template <class P, template <class...> class Search>
Snapshot uninterrupted(bool periodic) {
  auto system = moving_system<P, Search>(periodic);
  advance(system, 37);
  return snapshot_of(system);
}
template <class P>
auto moving(bool periodic = true) {
  return moving_system<P, VerletList>(periodic);
}

/// As of a system that never built lists.
void forget_lists(Snapshot& snapshot) {
  for (auto& counter : snapshot.counters) counter.second = 0;
  for (auto& array : snapshot.arrays)
    if (array.name == "neighbours/material" || array.name == "neighbours/wall") array.bytes.clear();
}

/// The functions of WendlandC4, without its name.
struct Unnamed {
  static constexpr double support = WendlandC4::support;
  template <class T>
  SCREE_FN static T w(T q) {
    return WendlandC4::w(q);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return WendlandC4::dw_over_q(q);
  }
  template <int Dim>
  static constexpr double sigma() {
    return WendlandC4::sigma<Dim>();
  }
};
namespace one {
struct Shape : Unnamed {};
}  // namespace one
namespace another {
struct Shape : Unnamed {};
template <int>
struct Numbered : Unnamed {};
}  // namespace another
/// A kernel that was moved and keeps the name that it had.
struct Moved : Unnamed {
  static constexpr char const* name = "Shape";
};
struct Derived : WendlandC4 {};
template <class Kernel>
auto moving_with() {
  return moving<Policy<2, double, Kokkos::DefaultHostExecutionSpace, Kernel>>();
}

template <class Sys>
void check_refused(Sys& system, Snapshot const& snapshot, std::string const& why) {
  auto const before = snapshot_of(system);
  CHECK_THROWS_MATCHES(restore_into(system, snapshot), std::runtime_error, MessageMatches(ContainsSubstring(why)));
  CHECK(snapshot_of(system) == before);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a run that goes on from a snapshot ends with the same bits", "", Policies) {
  using P = TestType;
  for (bool const periodic : {false, true}) {
    INFO("periodic " << periodic);
    auto const with_list = uninterrupted<P, VerletList>(periodic), with_cells = uninterrupted<P, CellList>(periodic);
    for (int const stop : {0, 1, 20, 36, 37}) {
      INFO("after step " << stop);
      CHECK(resumed<P, VerletList>(periodic, stop) == with_list);
      CHECK(resumed<P, CellList>(periodic, stop) == with_cells);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("a snapshot changes nothing, and may be taken at any step", "", Policies) {
  using P = TestType;
  auto system = moving<P>();
  for (int step = 0; step < 37; ++step) {
    auto const once = snapshot_of(system);
    CHECK(snapshot_of(system) == once);
    advance(system, 1);
  }
  CHECK(snapshot_of(system) == uninterrupted<P, VerletList>(true));
}

TEST_CASE("without the positions of the lists the bits differ") {
  // If this fails, the test above no longer tests anything: lists must be kept for a while, and their order must
  // matter.
  auto const whole = uninterrupted<OnHost, VerletList>(false);
  int different = 0;
  auto first = moving<OnHost>(false);
  for (int stop = 1; stop < 37; ++stop) {
    advance(first, 1);
    auto snapshot = snapshot_of(first);
    forget_lists(snapshot);
    auto second = moving<OnHost>(false);
    restore_into(second, snapshot);
    advance(second, 37 - stop);
    bool const same = snapshot_of(second).find("material/position")->bytes == whole.find("material/position")->bytes;
    different += !same;
  }
  CHECK(different > 10);
  CHECK(first.neighbour_builds() > 3);
  CHECK(first.neighbour_builds() < 20);
}

TEST_CASE("a snapshot without lists makes a system build them") {
  auto first = moving<OnHost>(false), second = moving<OnHost>(false);
  advance(first, 5);
  auto snapshot = snapshot_of(first);
  forget_lists(snapshot);  // not even stale
  restore_into(second, snapshot);
  advance(second, 1);
  CHECK(second.neighbour_builds() == 1);
}

TEST_CASE("a system that has run already can be brought back") {
  auto system = moving<OnHost>();
  advance(system, 20);
  auto const then = snapshot_of(system);
  advance(system, 17);
  auto const end = snapshot_of(system);
  restore_into(system, then);
  CHECK(snapshot_of(system) == then);
  advance(system, 17);
  CHECK(snapshot_of(system) == end);
  auto const unused = snapshot_of(moving<OnHost>());
  restore_into(system, unused);
  CHECK(snapshot_of(system) == unused);
  advance(system, 37);
  CHECK(snapshot_of(system) == end);
}

TEST_CASE("a snapshot names its arrays with unit and layout") {
  auto const snapshot =
      snapshot_of(moving_system<Policy<3, float, Kokkos::DefaultHostExecutionSpace>, VerletList>(true));
  auto const layout = [&](char const* name) { return snapshot.find(name) ? snapshot.find(name)->layout() : "none"; };
  CHECK(layout("material/position") == "3 x float32, m");
  CHECK(layout("material/velocity") == "3 x float32, m/s");
  CHECK(layout("material/previous velocity") == "3 x float32, m/s");
  CHECK(layout("material/identity") == "1 x int32, 1");
  CHECK(layout("material/kernel sum") == "1 x float32, 1");
  CHECK(layout("material/kernel sum (2)") == "1 x float32, 1");  // that over the wall
  CHECK(layout("wall/volume") == "1 x float32, m^dim");
  CHECK(layout("neighbours/material") == "3 x float32, m");
  CHECK(layout("neighbours/crossed") == "1 x float64, of the skin");
  CHECK(snapshot.find("material/position")->count() == 512);
  CHECK(snapshot.find("wall/position")->count() == 20);  // owned ones, no images
  CHECK_THAT(snapshot.signature, ContainsSubstring("dimension: 3\nprecision: float32\nkernel: WendlandC2\n"
                                                   "smoothing length: 0.18000000715255737 m\nsearch: VerletList\n"
                                                   "material particles: 512\nwall particles: 20\n"));
  CHECK_THAT(snapshot.signature, ContainsSubstring("\nmaterial/velocity: 3 x float32, m/s\n"));
}

TEST_CASE("a snapshot that does not fit is refused with the entry that differs") {
  auto system = moving<OnHost>();
  advance(system, 3);
  using Single = Policy<2, float, Kokkos::DefaultHostExecutionSpace>;
  using Solid = Policy<3, double, Kokkos::DefaultHostExecutionSpace>;
  auto single = snapshot_of(moving<Single>());
  check_refused(system, single,
                "scree: the snapshot: does not fit this run: 'precision' is float64 in this run and float32 in the");
  single.origin = "out/checkpoint.h5";
  check_refused(system, single, "out/checkpoint.h5: does not fit this run: 'precision'");
  check_refused(system, snapshot_of(moving<Solid>()), "'dimension' is 2 in this run and 3 in the snapshot");
  check_refused(system, snapshot_of(moving_system<OnHost, CellList>(true)),
                "'search' is VerletList in this run and CellList in the snapshot");
  check_refused(system, snapshot_of(moving_system<OnHost, VerletList>(true, 1.6)),
                "'smoothing length' is 0.089999999999999997 m in this run and 0.10000000000000001 m");
  auto fewer = moving<OnHost>();
  fewer.body<Wall>().resize(19);
  check_refused(system, snapshot_of(fewer), "'wall particles' is 20 in this run and 19 in the snapshot");
  TwoBodies<OnHost, VerletList<OnHost>, Fields<Position>, Fields<Position>> bare(1.44 * 0.0625,
                                                                                 system.ghosts().settings());
  bare.body<Material>().resize(256);
  bare.body<Wall>().resize(20);
  check_refused(system, snapshot_of(bare), "this run has 'material/identity' (1 x int32, 1), the snapshot has not");
  check_refused(bare, snapshot_of(system), "the snapshot has 'material/identity' (1 x int32, 1), this run has not");
  check_refused(system, Snapshot{}, "this run has 'dimension' (2), the snapshot has not");
}

TEST_CASE("a snapshot whose arrays are not those of its signature is refused") {
  auto system = moving<OnHost>();
  advance(system, 3);
  auto const good = snapshot_of(system);
  auto const changed = [&](std::string const& name, auto change) {
    auto bad = good;
    for (auto& array : bad.arrays)
      if (array.name == name) change(array);
    return bad;
  };
  check_refused(system, changed("wall/volume", [](auto& array) { array.name = "x"; }),
                "'wall/volume' (1 x float64, m^dim) is missing");
  check_refused(system, changed("wall/volume", [](auto& array) { array.bytes.resize(8); }),
                "'wall/volume' has values of 1 particles instead of 20");
  check_refused(system, changed("wall/volume", [](auto& array) { array.element = ElementType::int32; }),
                "'wall/volume' is 1 x int32, m^dim instead of 1 x float64, m^dim");
  check_refused(system, changed("neighbours/wall", [](auto& array) { array.name = "x"; }),
                "'neighbours/wall' (2 x float64, m) is missing");
  check_refused(system, changed("neighbours/wall", [](auto& array) { array.bytes.resize(16); }),
                "'neighbours/wall' has 1 values instead of 20");
}

TEST_CASE("counters are kept in groups") {
  Snapshot snapshot;
  add_counters(snapshot, "step limits", {{"sound", 3}, {"force", 4}});
  add_counters(snapshot, "step", {{"x", 5}});
  CHECK(counters_of(snapshot, "step limits") == std::map<std::string, long>{{"sound", 3}, {"force", 4}});
  CHECK(counters_of(snapshot, "step") == std::map<std::string, long>{{"x", 5}});
  CHECK(counters_of(snapshot, "other").empty());
}

TEST_CASE("kernels of one short name are told apart, by namespaces, arguments or a name of their own") {
  auto shape = moving_with<one::Shape>();
  check_refused(shape, snapshot_of(moving_with<another::Shape>()),
                "'kernel' is scree::test::snapshot_tests::(anonymous namespace)::one::Shape in this run and "
                "scree::test::snapshot_tests::(anonymous namespace)::another::Shape in the");
  auto numbered = moving_with<another::Numbered<1>>();
  check_refused(numbered, snapshot_of(moving_with<another::Numbered<2>>()), "'kernel'");
  auto moved = moving_with<Moved>();
  Snapshot old = snapshot_of(shape);
  std::size_t const from = old.signature.find("kernel: ") + 8;
  old.signature.replace(from, old.signature.find('\n', from) - from, "Shape");  // as a version wrote it before
  restore_into(moved, old);
  CHECK(snapshot_of(moved).arrays == old.arrays);
  auto derived = moving_with<Derived>();
  check_refused(derived, snapshot_of(moving_with<WendlandC4>()), "'kernel'");
  CHECK(detail::name_of_class<ReproducibleList<OnHost>>() == "ReproducibleList");
}

}  // namespace scree::test::snapshot_tests
