// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "checkpoint_file.hpp"

#include <scree/snapshots/snapshot_of.hpp>

#include <support/moving_particles.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// Entries that a file can hold but no run can have. The name excludes this file from builds for CUDA.
namespace scree::test::checkpoint_restart_crafted_tests {
namespace {

using namespace checkpoint_test;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

SnapshotArray& array_in(Snapshot& snapshot, std::string const& name) {
  for (auto& array : snapshot.arrays)
    if (array.name == name) return array;
  throw std::logic_error(name);
}

/// A system of moving particles and its snapshot, written to a file and read back.
struct Restart {
  Folder folder;
  std::filesystem::path file = folder / "checkpoint.h5";
  MovingSystem<OnHost, VerletList> system;
  Snapshot good;

  explicit Restart(bool periodic) : system(moving_system<OnHost, VerletList>(periodic)) {
    advance(system, 3);
    good = snapshot_of(system);
  }
  std::string complaint_about(Snapshot const& snapshot) {
    write_checkpoint(file, snapshot);
    return complaint_of([&] { restore_into(system, read_checkpoint(file)); });
  }
  template <class Change>
  void check_refused(Change change, std::string const& why) {
    auto bad = good;
    change(bad);
    CHECK(complaint_about(bad) == file.string() + ": " + why);
    CHECK(snapshot_of(system) == good);
  }
};

}  // namespace

TEST_CASE("a checkpoint with a clock or a counter out of range is refused") {
  Restart restart(true);
  CHECK(restart.complaint_about(restart.good) == "");
  double const infinity = std::numeric_limits<double>::infinity();
  long const most = std::numeric_limits<long>::max();
  restart.check_refused([](auto& s) { s.time = std::nan(""); }, "'time' is nan s");
  restart.check_refused([&](auto& s) { s.time = infinity; }, "'time' is inf s");
  restart.check_refused([](auto& s) { s.time = -0.5; }, "'time' is -0.5 s");
  restart.check_refused([](auto& s) { s.steps = -5; }, "'steps' is -5");
  restart.check_refused([&](auto& s) { s.steps = most; }, "'steps' is 9223372036854775807");
  for (std::string const name : {"builds", "updates", "last look", "next look", "stale", "wrap due"}) {
    auto const counter = "neighbours/" + name;
    restart.check_refused([&](auto& s) { s.counters[counter] = -1; }, "'" + counter + "' is -1");
    restart.check_refused([&](auto& s) { s.counters[counter] = most; }, "'" + counter + "' is 9223372036854775807");
  }
  restart.check_refused([](auto& s) { s.counters["step limits/sound"] = -1; }, "'step limits/sound' is -1");
}

TEST_CASE("a checkpoint with counters of lists that its steps cannot have left is refused") {
  Restart restart(true);
  auto const refused = [&](std::string const& name, long count, std::string const& range) {
    auto const counter = "neighbours/" + name;
    restart.check_refused([&](auto& s) { s.counters[counter] = count; },
                          fmt::format("'{}' is {}, and must be from {}", counter, count, range));
  };
  auto const of_good = [&](char const* name) { return restart.good.counters.at(std::string("neighbours/") + name); };
  long const updates = of_good("updates"), last = of_good("last look"), builds = of_good("builds");
  REQUIRE(updates > 0);
  restart.check_refused([](auto& s) { s.counters["neighbours/builds"] = 0; },
                        fmt::format("'neighbours/updates' is {}, and must be from 0 to 0", updates));
  refused("updates", 1001, "0 to 1000");
  refused("updates", 1L << 61, "0 to 1000");
  refused("last look", updates + 1, fmt::format("0 to {}", updates));
  refused("last look", 4'600'000'000'000'000'000, fmt::format("0 to {}", updates));
  refused("next look", last + 257, fmt::format("0 to {}", last + 256));
  refused("next look", 1'000'000'000'000'000, fmt::format("0 to {}", last + 256));
  refused("stale", 2, "0 to 1");
  refused("wrap due", 2, "0 to 1");
  refused("unsettled", builds + 1, fmt::format("0 to {}", builds));
  auto later = restart.good;
  later.steps = 1L << 62;
  CHECK(restart.complaint_about(later) == "");
}

TEST_CASE("a checkpoint with wrong positions behind the lists is refused") {
  for (bool const periodic : {false, true}) {
    INFO("periodic " << periodic);
    Restart restart(periodic);
    for (std::string const name : {"neighbours/material", "neighbours/wall"}) {
      auto const size = array_in(restart.good, name).count();
      auto const resized = [&](std::size_t to) {
        return [=](Snapshot& s) { array_in(s, name).bytes.resize(16 * to, array_in(s, name).bytes.back()); };
      };
      auto const of = [&](std::size_t count, std::size_t expected) {
        return fmt::format("'{}' has {} values instead of {}", name, count, expected);
      };
      auto const owned = std::size_t(name == "neighbours/wall" ? 20 : 256);
      restart.check_refused(resized(size + 1), of(size + 1, size));
      restart.check_refused(resized(100'000), of(100'000, size));
      restart.check_refused(resized(1), of(1, owned));
      // A system that never built lists has none; these counters claim that it did not.
      for (std::size_t const count : {std::size_t(1), owned, size})
        restart.check_refused(
            [&](Snapshot& s) {
              resized(count)(s);
              for (auto const& name_of_other : {"neighbours/material", "neighbours/wall"})
                if (name_of_other != name) array_in(s, name_of_other).bytes.clear();
              for (auto const* counter : {"builds", "updates", "last look", "next look"})
                s.counters[std::string("neighbours/") + counter] = 0;
            },
            "'" + name + "' has values, and 'neighbours/builds' is 0");
      restart.check_refused(
          [&](Snapshot& s) {
            double const nan = std::nan("");
            std::memcpy(&array_in(s, name).bytes.at(16 * (owned - 1)), &nan, 8);
          },
          "'" + name + "' has a position that is not finite");
      restart.check_refused(
          [&](Snapshot& s) {
            s.counters["neighbours/stale"] = 0;
            auto& present = array_in(s, name.substr(11) + "/position").bytes;
            *reinterpret_cast<double*>(&present.at(16 * 5)) += 1;
          },
          "'" + name + "' is too far from '" + name.substr(11) + "/position' for lists that are not stale");
    }
    auto const crossed = [&](double value) {
      return [=](Snapshot& s) { std::memcpy(array_in(s, "neighbours/crossed").bytes.data(), &value, 8); };
    };
    auto const why = "'neighbours/crossed' is not one number from 0 to below 1";
    restart.check_refused(crossed(std::nan("")), why);
    restart.check_refused(crossed(-1), why);
    restart.check_refused(crossed(1), why);
    restart.check_refused([](Snapshot& s) { array_in(s, "neighbours/crossed").bytes.clear(); }, why);
  }
}

TEST_CASE("a checkpoint of a run with other periods is refused") {
  Restart open(false), periodic(true);
  open.check_refused([&](auto& s) { s = periodic.good; },
                     "does not fit this run: the snapshot has 'period along axis 0' (0 to 1 m), this run has not");
  periodic.check_refused([&](auto& s) { s = open.good; },
                         "does not fit this run: this run has 'period along axis 0' (0 to 1 m), the snapshot has not");
  // The same with a false signature.
  auto lies = periodic.good;
  lies.signature = open.good.signature;
  CHECK(open.complaint_about(lies).find("'neighbours/material' has ") != std::string::npos);
}

TEST_CASE("a snapshot whose bytes end within a value is refused") {
  Restart restart(false);
  auto bad = restart.good;
  array_in(bad, "neighbours/material").bytes.resize(256 * 16 + 5);
  CHECK(complaint_of([&] { restore_into(restart.system, bad); }) ==
        "scree: the snapshot: 'neighbours/material' ends within the values of a particle");
}

}  // namespace scree::test::checkpoint_restart_crafted_tests
