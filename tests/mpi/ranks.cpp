// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/gathered.hpp>
#include <scree/distributed/mpi.hpp>
#include <scree/distributed/other_parts.hpp>
#include <scree/distributed/run_on_parts.hpp>
#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <cstdio>
#include <stdexcept>
#include <string>

// Run by mpirun: with `same-bits`, a column that collapses on all ranks must end with the bits of one part; with
// `fail`, one rank throws.
namespace scree::test {
namespace {

using Host = Kokkos::DefaultHostExecutionSpace;

struct Collapse : Formulation<2> {
  using space = Host;
  using physics = Granular<>;
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherParts<P>;
};

std::uint64_t end_of(Team<Host> const& team, Host const& space) {
  double const dr = 0.01;
  SolverSettings<Collapse> settings{.spacing = dr, .parts = {.team = team}};
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  Solver<Collapse> solver(space, settings, fill(Box<2>{{0, 0}, {0.2, 0.3}}, dr),
                          wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4));
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
  for (int k = 0; k < 200; ++k) solver.step(1);
  return state_hash(solver);
}

bool same_bits() {
  std::uint64_t one = 0, here = 0;
  run_on_parts<Host>(1, [&](Team<Host> const& team, Host const& space) { one = end_of(team, space); });
  bool same = false;
  run_on_ranks<Host>([&](Team<Host> const& team, Host const& space) {
    here = end_of(team, space);
    ExactSum sum;
    sum += 0.1 * (team.part() + 1);
    bool const sums = team.sum(sum) == [&] {
      ExactSum all;
      for (int q = 0; q < team.parts(); ++q) all += 0.1 * (q + 1);
      return all.value();
    }();
    same = team.smallest(int(here == one && sums)) == 1;
    if (team.part() == 0)
      std::printf("%d ranks: %016lx, one part: %016lx\n", team.parts(), static_cast<unsigned long>(here),
                  static_cast<unsigned long>(one));
  });
  return same;
}

void fail() {
  run_on_ranks<Host>([&](Team<Host> const& team, Host const&) {
    team.gather(1);
    if (team.part() == 1) throw std::runtime_error("no sand");
    for (;;) team.gather(2);
  });
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  bool good = true;
  {
    Kokkos::ScopeGuard const kokkos(argc, argv);
    if (argc > 1 && std::string(argv[1]) == "fail")
      scree::test::fail();
    else
      good = scree::test::same_bits();
  }
  MPI_Finalize();
  return good ? 0 : 1;
}
