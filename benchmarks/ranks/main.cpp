// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "memory.hpp"
#include "plan.hpp"

#include <scree/core/space.hpp>
#include <scree/distributed/link.hpp>
#include <scree/distributed/run_on_mpi.hpp>
#include <scree/distributed/run_on_threads.hpp>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <optional>

// A case in 3D on one and several ranks: threads, or the processes of mpirun where the build has SCREE_MPI. Prints a
// table in Markdown.
namespace scree::bench {

using Space = Kokkos::DefaultExecutionSpace;
void add_rows_in_float(Team<Space> const& team, Space const& space, Plan const& plan);
void add_rows_in_double(Team<Space> const& team, Space const& space, Plan const& plan);
void add_row_of_large(Team<Space> const& team, Space const& space, Plan const& plan);

namespace {

void run_rank(Team<Space> const& team, Space const& space, Plan const& plan) {
  Link const link = measured_link(team, space);
  if (team.rank() == 0)
    fmt::print(
        "{} ranks, {}: at least {:.3g} GB/s, 8 bytes in {:.3g} us\n\n"
        "| | ranks | particles | us/step | M particle-steps/s | ghosts, % | exchanges | kB sent by a rank | "
        "us in exchanges | least | us in reductions | steps a list lasts | hash |\n|{}\n",
        team.ranks(), team.name(space), 1e-9 * link.bandwidth, 1e6 * link.latency,
        "---|---|---|---|---|---|---|---|---|---|---|---|---|");
  if (plan.large) return add_row_of_large(team, space, plan);
  if (plan.in_float) add_rows_in_float(team, space, plan);
  if (plan.in_double) add_rows_in_double(team, space, plan);
}

void run(Plan const& plan) {
#ifdef SCREE_MPI
  if (MpiProgram::ranks() > 1) {
    Plan of_rank = plan;
    of_rank.one_process = false;
    return run_on_mpi<Space>([&](Team<Space> const& team, Space const& space) { run_rank(team, space, of_rank); });
  }
#endif
  run_on_threads<Space>(plan.ranks, [&](Team<Space> const& team, Space const& space) { run_rank(team, space, plan); });
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
#ifdef SCREE_MPI
  scree::MpiProgram const mpi(argc, argv);
#endif
  Kokkos::ScopeGuard const kokkos(argc, argv);
  scree::bench::count_memory();
  scree::bench::Plan plan;
  bool only_float = false, only_double = false;
  CLI::App app("Steps of a box of grains with segregation in 3D, on ranks");
  app.add_option("--particles", plan.particles, "of the case")->check(CLI::Range(1000.0, 2e9));
  app.add_flag("--per-rank", plan.per_rank, "so many for each rank, one box behind the other");
  app.add_option("--length", plan.length, "of the case along x, or of each rank; depth and width are 1");
  app.add_option("--shear", plan.shear, "of the start, 1/s");
  app.add_option("--ranks", plan.ranks, "threads, without mpirun")->check(CLI::Range(1, 64));
  app.add_option("--steps", plan.steps, "timed together")->check(CLI::Range(1, 1000000));
  app.add_option("--warm-up", plan.warm_up, "steps before")->check(CLI::Range(0, 1000000));
  app.add_option("--repetitions", plan.repetitions, "the median counts")->check(CLI::Range(1, 1000));
  app.add_flag("--divided", plan.divided, "each rank begins with its share of the particles");
  auto* const large =
      app.add_flag("--large", plan.large, "in single precision, with lists of more than 2^32 candidates on a GPU");
  app.add_flag("--memory", plan.memory, "print the peaks of memory of the largest process");
  app.add_flag("--hash", plan.hash, "print a hash of the state at the end");
  auto* const in_float = app.add_flag("--float", only_float, "only in single precision");
  app.add_flag("--double", only_double, "only in double precision")->excludes(in_float)->excludes(large);
  CLI11_PARSE(app, argc, argv);
  plan.in_float = !only_double, plan.in_double = !only_float;
  try {
    scree::bench::run(plan);
  } catch (std::exception const& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
