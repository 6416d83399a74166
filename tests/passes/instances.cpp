// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/neighbours/brute_force.hpp>
#include <scree/run/run_study.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/terms/kernel_sums.hpp>

#include <support/backends.hpp>
#include <support/formulations.hpp>
#include <support/instances.hpp>
#include <support/shear_box.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <future>
#include <thread>

// Solvers on several instances of an execution space.
namespace scree::test::instances_tests {
using namespace fields;
namespace {

/// A block with fast shear between its periodic ends, over a floor: lists, images, sorting and filters.
template <class Space>
struct Sheared : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
};
template <class Space>
Solver<Sheared<Space>> sheared(Space const& space, double speed, int sort_period = 10) {
  SolverSettings<Sheared<Space>> settings{.spacing = 0.1, .periods = {{0, 0, 1}}, .sort_period = sort_period};
  settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
  settings.physics.filter.period = 7;
  auto const bed = layer({1, 0.6}, 0.1);
  Solver<Sheared<Space>> solver(space, settings, bed.material, bed.wall);
  solver.set(stress, [](auto const& x) { return (1500 * 9.81 * (x[1] - 0.6) * Vec<4, double>(1, 1, 1, 0)).eval(); });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(speed * x[1], 0.1 * std::sin(6 * x[0])); });
  return solver;
}

/// A box in oscillating shear: cell lists, and a search for surfaces in each step.
template <class Space>
struct Segregating : Formulation<2> {
  using space = Space;
  using physics = HybridSegregation<ConstantClosure>;
  using motion = OscillatingShear;
  template <class P>
  using search = CellList<P>;
};
template <class Space>
Solver<Segregating<Space>> segregating(Space const& space) {
  auto const bed = open_bed<2>({shear_box::width, 1}, 0.05);
  Solver<Segregating<Space>> solver(
      space, {.spacing = 0.05, .physics = {.closure = shear_box::closure()}, .motion = shear_box::motion()},
      bed.material, bed.wall);
  solver.set(concentration, [](auto const& x) { return shear_box::layered(x[1]); });
  return solver;
}

template <class S>
void run_slice(S& solver, int k) {
  solver.run(0.02 * k);
}
/// The end of a run in slices.
template <class Make>
Snapshot end_of(Make const& make, int slices) {
  auto solver = make();
  for (int k = 1; k <= slices; ++k) run_slice(solver, k);
  return solver.snapshot();
}
template <class A, class B>
void check_at_once(A const& first, B const& second) {
  int const slices = 30;
  auto const of_first = end_of(first, slices), of_second = end_of(second, slices);
  for (int repetition = 0; repetition < 3; ++repetition) {
    auto beside = std::async(std::launch::async, [&] { return end_of(second, slices); });
    CHECK(end_of(first, slices) == of_first);
    CHECK(beside.get() == of_second);
  }
}

struct WaitForEnd {
  int volatile *started, *ended;
  SCREE_FN void operator()(int) const {
    *started = 1;
    while (*ended == 0) {
    }
  }
};
/// Keeps an instance busy until its end.
template <class Space>
class Busy {
 public:
  explicit Busy(Space const& space)
      : thread_([this, space] {
          Kokkos::parallel_for("scree::test::busy", Kokkos::RangePolicy<Space>(space, 0, 1),
                               WaitForEnd{&note(0), &note(1)});
          space.fence();
        }) {
    while (note(0) == 0) std::this_thread::yield();
  }
  Busy(Busy const&) = delete;
  Busy& operator=(Busy const&) = delete;
  ~Busy() {
    note(1) = 1;
    thread_.join();
  }

 private:
  int volatile& note(int k) const { return reinterpret_cast<int volatile*>(notes_.data())[k]; }
  static Memory<Kokkos::SharedHostPinnedSpace> zeros() {
    Memory<Kokkos::SharedHostPinnedSpace> const memory("scree::test::busy", 2 * sizeof(int));
    std::memset(memory.data(), 0, memory.size());
    return memory;
  }

  Memory<Kokkos::SharedHostPinnedSpace> notes_ = zeros();
  std::thread thread_;
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("two solvers in two threads give the bits of two runs one after the other", "", Backends) {
  auto const [one, other] = two_instances<TestType>();
  REQUIRE(one != other);
  auto const slow = [one = one] { return sheared(one, 1); };
  check_at_once(slow, [other = other] { return sheared(other, 3); });
  check_at_once(slow, [other = other] { return segregating(other); });
}

TEMPLATE_LIST_TEST_CASE("a study gives the same bits for any number of workers", "", Backends) {
  std::vector<std::function<Snapshot(TestType const&)>> cases;
  for (double const speed : {1.0, 2.0, 3.0, 4.0, 5.0})
    cases.push_back([=](TestType const& space) { return end_of([&] { return sheared(space, speed); }, 15); });
  auto const alone = run_study<TestType>(cases, 1);
  for (int const workers : {2, 5}) {
    auto const at_once = run_study<TestType>(cases, workers);
    for (std::size_t k = 0; k < cases.size(); ++k) CHECK(at_once[k].result.value() == alone[k].result.value());
  }
}

TEMPLATE_LIST_TEST_CASE("an instance changes no bit", "", Backends) {
  auto const one = two_instances<TestType>()[0];
  auto const sheared_on = [](TestType const& space) { return end_of([&] { return sheared(space, 3); }, 30); };
  CHECK(sheared_on(one) == sheared_on(TestType()));
  auto const segregating_on = [](TestType const& space) { return end_of([&] { return segregating(space); }, 30); };
  CHECK(segregating_on(one) == segregating_on(TestType()));
}

// Unlike the threads above, this finds at every run what one solver leaves in the memory of another.
TEMPLATE_LIST_TEST_CASE("two solvers that run in turn give the bits of two runs one after the other", "", Backends) {
  auto const [one, other] = two_instances<TestType>();
  auto first = sheared(one, 1), second = sheared(other, 3);
  auto third = segregating(other);
  for (int k = 1; k <= 15; ++k) run_slice(first, k), run_slice(second, k), run_slice(third, k);
  CHECK(first.snapshot() == end_of([one = one] { return sheared(one, 1); }, 15));
  CHECK(second.snapshot() == end_of([other = other] { return sheared(other, 3); }, 15));
  CHECK(third.snapshot() == end_of([other = other] { return segregating(other); }, 15));
}

TEMPLATE_LIST_TEST_CASE("a solver on one instance does not wait for another", "", Backends) {
  auto const one = two_instances<TestType>()[0];
  auto solver = sheared(one, 3, 0);
  solver.run(3.7);  // its memory has grown to its full size
  long const builds = solver.neighbour_builds();
  std::future<void> run;
  {
    Busy<TestType> const busy{TestType()};
    run = std::async(std::launch::async, [&] { solver.run(4); });
    CHECK(run.wait_for(std::chrono::seconds(20)) == std::future_status::ready);
  }
  run.get();
  CHECK(solver.neighbour_builds() > builds + 2);
}

TEMPLATE_LIST_TEST_CASE("what is made from a solver runs on its instance", "", Backends) {
  auto const one = two_instances<TestType>()[0];
  auto const solver = sheared(one, 1);
  CHECK(solver.space() == one);
  CHECK(solver.material().space() == one);
  CHECK(solver.wall()[position].space() == one);
  CHECK(solver.wall()[position].part(0, 1).space() == one);
  auto const by_default = sheared(TestType(), 1);
  CHECK(by_default.space() == TestType());
}

TEMPLATE_LIST_TEST_CASE("particles of two instances in one loop stop with a message", "", Backends) {
  using P = Basis<2, double, WendlandC2, TestType>;
  auto const [one, other] = two_instances<TestType>();
  using Body = Particles<P, Fields<Position, Volume, KernelSum<Material>, KernelGradient<Material>>>;
  Body const here(one, 3), there(other, 3);
  auto const message = Catch::Matchers::ContainsSubstring("must be made on the same execution-space instance");
  auto const sum_over = [&](Body const& sources) {
    BruteForce<P> search(1);
    search.update(here[position], sources[position]);
    for_each_pair(PairLoopOptions<P>{"sums", kernel_of<P>(0.5)}, here, from(sources, search, KernelSums<Material>{}));
  };
  CHECK_NOTHROW(sum_over(here));
  CHECK_THROWS_WITH(sum_over(there), message);
  CHECK_THROWS_WITH(copy_array(here[position], there[position]), message);
}

}  // namespace scree::test::instances_tests
