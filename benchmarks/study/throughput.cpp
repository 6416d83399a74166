// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../step/box.hpp"
#include "launches.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

// Throughput of several solvers at once, each in a host thread on an instance of its own, against the same solvers one
// after the other. Prints tables in Markdown.
//     bench_study [--particles 2000,7500,50000] [--solvers 1,2,4,8,16] [--steps 3000] [--warm-up 300] [--launches
//     20000]
namespace scree::bench {
namespace {

/// Like the drum: mu(I) with volume control and filter in 2D, double, five launches in most steps.
struct Member : GranularBox<2, double> {
  using integrator = SymplecticEuler;
};
using S = Solver<Member>;

struct Plan {
  std::vector<int> particles = {2000, 7500, 50'000}, solvers = {1, 2, 4, 8, 16};
  int steps = 3000, warm_up = 300, launches = 20'000;
};

std::vector<int> numbers(std::string const& text) {
  std::vector<int> found;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find(',', at), text.size() - 1) + 1)
    found.push_back(std::max(1, std::atoi(text.c_str() + at)));
  return found;
}
Plan plan_of(int argc, char** argv) {
  Plan plan;
  for (int k = 1; k + 1 < argc; k += 2) {
    std::string const name = argv[k];
    auto const given = numbers(argv[k + 1]);
    if (name == "--particles") plan.particles = given;
    if (name == "--solvers") plan.solvers = given;
    if (name == "--steps") plan.steps = given[0];
    if (name == "--warm-up") plan.warm_up = given[0];
    if (name == "--launches") plan.launches = given[0];
  }
  return plan;
}

void advance(S& solver, int steps) {
  long const last = solver.steps() + steps;
  solver.run(
      solver.time() + 1e3, {}, [](S const&) { return true; }, [&] { return solver.steps() >= last; });
}
/// Slow enough that lists live about 300 steps, as in the drum.
S member(int number, int particles, Space const& space) {
  return box<Member>({.particles = double(particles), .shear = 0.03 + 0.001 * number}, space);
}

struct Timed {
  double seconds = 0, particles = 0;
  std::vector<Snapshot> ends = {};
};

/// Solvers number `first` and following, at once.
Timed run_at_once(int first, int count, int particles, Plan const& plan) {
  auto const instances = instances_of<Space>(count);
  std::vector<std::unique_ptr<S>> solvers(instances.size());
  auto const prepare = [&](int k) {
    auto& solver = solvers[std::size_t(k)];
    solver = std::make_unique<S>(member(first + k, particles, instances[std::size_t(k)]));
    advance(*solver, plan.warm_up);
    solver->space().fence();
  };
  auto const work = [&](int k) {
    advance(*solvers[std::size_t(k)], plan.steps);
    solvers[std::size_t(k)]->space().fence();
  };
  Timed timed{.seconds = seconds_of(count, prepare, work)};
  for (auto const& solver : solvers) {
    timed.ends.push_back(solver->snapshot());
    timed.particles += double(solver->material().size()) + solver->wall().size();
  }
  return timed;
}

/// The same one after the other.
Timed run_in_turn(int count, int particles, Plan const& plan) {
  Timed all;
  for (int k = 0; k < count; ++k) {
    auto timed = run_at_once(k, 1, particles, plan);
    all.seconds += timed.seconds, all.particles += timed.particles;
    all.ends.push_back(std::move(timed.ends.front()));
  }
  return all;
}

void print_launches(Plan const& plan) {
  std::printf("| threads | launches/s of one kernel | of one for each thread |\n|---|---|---|\n");
  for (int const threads : plan.solvers)
    std::printf("| %d | %.3g | %.3g |\n", threads, launch_rate(threads, plan.launches, true),
                launch_rate(threads, plan.launches, false));
}

void print_census(int particles, Plan const& plan) {
  auto solver = member(0, particles, Space());
  advance(solver, plan.warm_up);
  long const builds = solver.neighbour_builds();
  auto const census = census_of([&] { advance(solver, plan.steps); });
  std::printf("\n%d particles and %d of walls: %.2f launches, %.3f waits and %.4f builds of lists per step\n\n",
              solver.material().size(), solver.wall().size(), double(census.launches) / plan.steps,
              double(census.waits) / plan.steps, double(solver.neighbour_builds() - builds) / plan.steps);
}

void print_size(int particles, Plan const& plan) {
  print_census(particles, plan);
  int const most = *std::max_element(plan.solvers.begin(), plan.solvers.end());
  auto const alone = run_in_turn(most, particles, plan);
  double const rate = alone.particles * plan.steps / alone.seconds;
  std::printf(
      "| solvers at once | us per step of each | ns per particle-step | particle-steps/s | against one after the "
      "other | bits |\n|---|---|---|---|---|---|\n");
  std::printf("| in turn | %.1f | %.3f | %.4g | 1 | |\n", 1e6 * alone.seconds / most / plan.steps, 1e9 / rate, rate);
  for (int const count : plan.solvers) {
    auto const timed = run_at_once(0, count, particles, plan);
    double const now = timed.particles * plan.steps / timed.seconds;
    bool const same = std::equal(timed.ends.begin(), timed.ends.end(), alone.ends.begin());
    std::printf("| %d | %.1f | %.3f | %.4g | %.2f | %s |\n", count, 1e6 * timed.seconds / plan.steps, 1e9 / now, now,
                now / rate, same ? "same" : "DIFFERENT");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  setenv("CUDA_DEVICE_MAX_CONNECTIONS", "32", 0);  // of the device; with fewer than streams, streams wait for others
  Kokkos::ScopeGuard const kokkos(argc, argv);
  auto const plan = scree::bench::plan_of(argc, argv);
  std::printf("%s, %u host threads\n\n", scree::bench::Space::name(), std::thread::hardware_concurrency());
  scree::bench::print_launches(plan);
  for (int const particles : plan.particles) scree::bench::print_size(particles, plan);
}
