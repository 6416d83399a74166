// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Components that take part in a run, and motions that change during it.
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/steered.hpp>
#include <scree/motion/translation.hpp>

#include <support/sudden.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace scree::test::components_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;
using Pushed = WithLists<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Steered<2>, SymplecticEuler>;
using InFloat = WithLists<Policy<2, float, Kokkos::DefaultHostExecutionSpace>, Steered<2>, Midpoint>;

/// Moves the plate towards the block and back, faster from turn to turn.
template <class S>
class Hammer : public Component<S> {
 public:
  explicit Hammer(long every) : every_(every) {}
  std::string log;
  long turns = 0;

  void start(S&) override { log += "start "; }
  bool is_due(S const& solver) const override { return solver.steps() % every_ == 0; }
  void act(S& solver) override {
    log += std::to_string(solver.steps()) + " ";
    ++turns;
    give(solver, solver.settings().motion.turned_to(V(turns % 2 == 0 ? -0.1 * double(turns) : 2, 0), solver.time()));
  }
  TimeStepLimit limit() const override { return {"hammer", turns < 3 ? 7e-5 : TimeStepLimit::never}; }
  std::string signature() const override { return "hammer: every " + std::to_string(every_) + " steps\n"; }
  void save(Snapshot& snapshot) const override {
    auto numbers = motion_.numbers();
    numbers.push_back(double(turns));
    add_numbers(snapshot, "hammer", "s, m, m, m/s, m/s, -", numbers);
  }
  std::function<void(S&)> read(Snapshot const& snapshot) override {
    auto const numbers = numbers_of(snapshot, "hammer", "s, m, m, m/s, m/s, -", 6);
    return [this, motion = Steered<2>::from_numbers(numbers), count = long(numbers.back())](S& solver) {
      turns = count;
      give(solver, motion);
    };
  }

 private:
  void give(S& solver, Steered<2> const& motion) { solver.set_motion(motion_ = motion); }
  long every_;
  Steered<2> motion_;
};

template <class P>
Solver<P> with_hammer(std::shared_ptr<Hammer<Solver<P>>> const& hammer) {
  auto solver = sudden::at_rest<P>({});
  solver.attach(hammer);
  return solver;
}
template <class P>
auto hammer(long every = 100) {
  return std::make_shared<Hammer<Solver<P>>>(every);
}
template <class S>
bool same(S const& a, S const& b) {
  return a.steps() == b.steps() && a.time() == b.time() &&
         a.material().to_host(position) == b.material().to_host(position) &&
         a.material().to_host(velocity) == b.material().to_host(velocity) &&
         a.wall().to_host(position) == b.wall().to_host(position) && a.limits() == b.limits();
}

}  // namespace

TEST_CASE("a component acts once in each state in which it is due") {
  auto const controller = hammer<Pushed>();
  auto solver = with_hammer<Pushed>(controller);
  solver.check_start();
  CHECK(controller->log == "start 0 ");
  auto const stop_at = [](long steps) { return [=](auto const& now) { return now.steps() >= steps; }; };
  solver.run(1, {}, stop_at(100));
  CHECK(controller->log == "start 0 100 ");
  solver.step(1), solver.run(1, {}, stop_at(250));
  CHECK(controller->log == "start 0 100 200 ");
  CHECK(controller->turns == 3);
  // Its limit sets the step until the third turn.
  CHECK(solver.limits() == std::map<std::string, long>{{"hammer", 200}, {"step", 50}});
  double const turn = 100 * 7e-5;  // s
  double const way = solver.wall().to_host(position)[0][0] - solver.wall().to_host(rest_position)[0][0];
  CHECK(std::abs(way - (2 * turn - 0.2 * turn + 2 * (solver.time() - 2 * turn))) < 1e-6);  // of 36 mm
}

TEMPLATE_TEST_CASE("a run with a component goes on from any step bit for bit, and is the same in pieces", "", Pushed,
                   InFloat) {
  using P = TestType;
  auto const a = hammer<P>(), b = hammer<P>();
  auto whole = with_hammer<P>(a), pieces = with_hammer<P>(b);
  std::vector<Snapshot> snapshots = {whole.snapshot()};
  whole.check_start();
  snapshots.push_back(whole.snapshot());  // it has acted
  long const end = 420;
  whole.run(1, {}, [&](auto const& now) {
    if (now.steps() % 50 == 0 || now.steps() == 101) snapshots.push_back(now.snapshot());
    return now.steps() >= end;
  });
  for (long const stop : {1, 99, 100, 101, 300, 420})
    pieces.run(1, {}, [&](auto const& now) { return now.steps() >= stop; });
  CHECK(same(whole, pieces));
  CHECK(a->log == b->log);
  for (auto const& snapshot : snapshots) {
    auto const controller = hammer<P>();
    auto second = with_hammer<P>(controller);
    second.restore(snapshot);
    second.run(1, {}, [&](auto const& now) { return now.steps() >= end; });
    INFO("from step " << snapshot.steps);
    CHECK(same(whole, second));
    bool const begins = controller->log.find("start") != std::string::npos;
    CHECK(begins == (&snapshot == &snapshots.front()));  // only where it had not begun
  }
}

TEST_CASE("a snapshot of a run with a component needs it") {
  auto const stop = [](auto const& now) { return now.steps() >= 150; };
  auto solver = with_hammer<Pushed>(hammer<Pushed>());
  solver.run(1, {}, stop);
  auto snapshot = solver.snapshot();
  auto without = sudden::at_rest<Pushed>({});
  CHECK_THROWS_WITH(without.restore(snapshot), ContainsSubstring("the snapshot has 'hammer' (every 100 steps)"));
  auto other = with_hammer<Pushed>(hammer<Pushed>(50));
  CHECK_THROWS_WITH(other.restore(snapshot), ContainsSubstring("'hammer' is every 50 steps in this run"));
  for (auto& array : snapshot.arrays)
    if (array.name == "hammer") array.bytes.resize(array.bytes.size() - 8);
  auto third = with_hammer<Pushed>(hammer<Pushed>());
  CHECK_THROWS_WITH(third.restore(snapshot), ContainsSubstring("'hammer' has 5 numbers instead of 6"));
  CHECK(third.steps() == 0);
  CHECK_THROWS_AS(third.attach(nullptr), std::invalid_argument);
}

TEST_CASE("a motion that changes must begin where the one before ends") {
  using P = Pushed;
  auto solver = sudden::at_rest<P>({});
  auto const x0 = solver.wall().to_host(position)[0];
  solver.set_motion(Steered<2>{}.turned_to(V(1, 0), 0));
  solver.run(0.01);
  CHECK(std::abs(solver.wall().to_host(position)[0][0] - x0[0] - 0.01) < 1e-15);
  CHECK_THROWS_WITH(solver.set_motion({}),
                    ContainsSubstring("the new motion would put particles of the wall 1 spacings "
                                      "from where they are at 0.01 s"));
  solver.set_motion(solver.settings().motion.turned_to(V(0, 2), solver.time()));
  solver.run(0.02);
  CHECK((solver.wall().to_host(position)[0] - x0 - V(0.01, 0.02)).norm() < 1e-15);
  CHECK_THROWS_AS(solver.set_motion({.since = -1}), std::invalid_argument);
}

TEST_CASE("a snapshot is not continued with a motion that has the walls elsewhere") {
  using P = Pushed;
  auto solver = sudden::at_rest<P>({}), second = sudden::at_rest<P>({});
  solver.run(0.02, {every<Solver<P>>(0.005, [](Solver<P>& now) {
               now.set_motion(now.settings().motion.turned_to(V(1 + 100 * now.time(), 0), now.time()));
             })});
  auto const snapshot = solver.snapshot();
  second.restore(snapshot);
  CHECK_THROWS_WITH(second.step(1), ContainsSubstring("the motion of the settings would put particles of the wall"));
  second.restore(snapshot);
  CHECK_THROWS_WITH(second.check_start(), ContainsSubstring("the motion of the settings"));
  CHECK_THROWS_WITH(second.step(1), ContainsSubstring("the motion of the settings"));  // again
  second.restore(snapshot);
  second.set_motion(solver.settings().motion);
  solver.run(0.03), second.run(0.03);
  CHECK(same(solver, second));

  // Another speed is another place.
  using Moved = WithLists<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Translation<2>, SymplecticEuler>;
  auto slow = sudden::at_rest<Moved>({.speed = {0.1, 0}}), fast = sudden::at_rest<Moved>({.speed = {0.2, 0}});
  slow.run(0.02);
  fast.restore(slow.snapshot());
  CHECK_THROWS_WITH(fast.run(0.03), ContainsSubstring("0.2 spacings from where they are at 0.02 s"));
}

namespace {

/// Is due after every step, and logs each call or fails.
template <class S>
class Recorder : public Component<S> {
 public:
  std::string log;
  bool fails_to_start = false, fails_to_act = false;
  void start(S&) override {
    if (fails_to_start) throw std::runtime_error("no file");
    log += "start ";
  }
  bool is_due(S const&) const override { return true; }
  void act(S& now) override {
    if (fails_to_act) throw std::runtime_error("no way");
    log += std::to_string(now.steps()) + " ";
  }
};
/// Turns once, and limits steps far below the others from then on, by what changes slowly.
template <class S>
class Late : public Component<S> {
 public:
  TimeStepLimit limit() const override { return {"late", turned_ ? 3e-5 : 1e-2, 1.0}; }
  bool is_due(S const& now) const override { return !turned_ && now.time() > 0.01; }
  void act(S& now) override { turned_ = true, give(now, now.time()); }
  void save(Snapshot& snapshot) const override { add_numbers(snapshot, "late", "1, s", {double(turned_), since_}); }
  std::function<void(S&)> read(Snapshot const& snapshot) override {
    auto const numbers = numbers_of(snapshot, "late", "1, s", 2);
    return [this, numbers](S& now) {
      turned_ = numbers[0] != 0;
      if (turned_) give(now, numbers[1]);
    };
  }

 private:
  void give(S& now, double since) {
    since_ = since;
    now.set_motion(Steered<2>{}.turned_to({0.1, 0}, since));
  }
  bool turned_ = false;
  double since_ = 0;
};

}  // namespace

TEST_CASE("a component starts before it acts, also one that is attached during a run, and again where it failed") {
  using S = Solver<Pushed>;
  auto solver = sudden::at_rest<Pushed>({});
  auto const late = std::make_shared<Recorder<S>>();
  solver.run(3e-4, {at<S>({1e-4}, [&](S& now) {
               if (now.time() > 0) now.attach(late);
             })});
  CHECK(late->log == "start 2 3 ");
  CHECK_THROWS_WITH(solver.attach(late), ContainsSubstring("attached already"));

  auto const failing = std::make_shared<Recorder<S>>();
  failing->fails_to_start = true;
  auto second = sudden::at_rest<Pushed>({});
  second.attach(failing);
  CHECK_THROWS_WITH(second.step(1), "no file");
  failing->fails_to_start = false, failing->fails_to_act = true;
  CHECK_THROWS_WITH(second.step(1), "no way");
  failing->fails_to_act = false;
  second.step(1);
  CHECK(failing->log == "start 0 1 ");
}

TEST_CASE("a restart looks at the limits of steps when the whole run did, also if a component sets the motion") {
  using S = Solver<Pushed>;
  auto const made = [] {
    auto solver = sudden::at_rest<Pushed>({});
    solver.attach(std::make_shared<Late<S>>());
    return solver;
  };
  auto whole = made();
  std::vector<Snapshot> snapshots;
  whole.run(0.03, {}, [&](S const& now) {
    if (now.steps() % 37 == 0) snapshots.push_back(now.snapshot());
    return false;
  });
  REQUIRE(snapshots.size() > 10);
  for (auto const& snapshot : snapshots) {
    auto second = made();
    second.restore(snapshot);
    CHECK(second.snapshot().counters == snapshot.counters);
    second.check_start();  // changes nothing
    second.run(0.03);
    INFO("from step " << snapshot.steps);
    CHECK(same(whole, second));
  }
}

}  // namespace scree::test::components_tests
