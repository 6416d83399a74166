// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../run/run_study.hpp"
#include "processes.hpp"
#include "start.hpp"
#include "streams.hpp"
#include "study.hpp"

#include <Kokkos_Core.hpp>

#include <cstdlib>
#include <string_view>
#include <vector>

namespace scree::app {

/// The execution space of the runs of a case program.
using Space = Kokkos::DefaultExecutionSpace;

namespace detail {

/// A simulation on a given instance of the execution space. A simulation that ignores the instance and uses the default
/// one sets `one_at_a_time`.
template <class T>
struct Simulation {
  std::function<int(Run<T> const&, Space const&)> run;
  bool one_at_a_time = false;
};

/// Runs the study that a command line requests and returns the exit code of the program.
template <class T>
int run_members(CommandLine const& line, Schema<T> const& schema, Program const& program,
                Simulation<T> const& simulation) {
  Interrupt const interrupt;
  Study study(line, schema.list(), &schema.standard(), program);
  std::vector<T> members(study.size(), schema.standard());
  for (std::size_t k = 0; k < members.size(); ++k) study.read(k, &members[k]);
  study.check();
  for (std::size_t k = 0; k < members.size(); ++k) {
    T scratch = schema.standard();
    study.look(k, &members[k], &scratch);
  }
  study.check();

  std::vector<std::function<bool(Space const&)>> cases;
  auto const run = [&](std::size_t k, Space const& space) {
    T& options = members[k];
    auto const any = study.begin(k, &options);
    return simulation.run({options, any.output, any.quiet, any.profile, any.case_text, any.directory}, space);
  };
  for (std::size_t k = 0; k < members.size(); ++k)
    if (!study.finished(k))
      cases.push_back([&, k](Space const& space) {
        study.run(k, [&] { return run(k, space); });
        return true;
      });
  for (auto const& end : run_study<Space>(cases, study.workers(simulation.one_at_a_time)))
    if (end.failure) std::rethrow_exception(end.failure);
  return study.finish(interrupt.exit_code());
}

/// Returns the name of a program and its arguments for Kokkos, which would otherwise print its own help for --help.
inline std::vector<char*> arguments_of_kokkos(int argc, char** argv) {
  std::vector<char*> words;
  for (int k = 0; k < argc; ++k)
    if (k == 0 || std::string_view(argv[k]).starts_with("--kokkos-")) words.push_back(argv[k]);
  return words;
}

inline namespace SCREE_CASES {
template <class T>
int run_program(int argc, char** argv, Program const& program, Schema<T> const& schema,
                Simulation<T> const& simulation) {
  guard_streams();
#ifdef KOKKOS_ENABLE_OPENMP
  // Kokkos warns if OMP_PROC_BIND is not set. Unless places are given, OpenMP's default is false.
  if (::getenv("OMP_PLACES") == nullptr) ::setenv("OMP_PROC_BIND", "false", 0);
#endif
#ifdef KOKKOS_ENABLE_CUDA
  ::setenv("CUDA_DEVICE_MAX_CONNECTIONS", "32", 0);  // fewer connections than streams make streams wait
#endif
  Processes const processes(argc, argv);
  auto of_kokkos = arguments_of_kokkos(argc, argv);
  int count = int(of_kokkos.size());
  Kokkos::ScopeGuard const kokkos(count, of_kokkos.data());
  return processes.end(outcome_of([&] {
    int exit_code = 0;
    auto const line = read_command_line({argv + 1, argv + argc}, program, exit_code);
    if (!line) return exit_code;
    processes.check(*line);
    if (line->is_study() && !line->options) return run_members(*line, schema, program, simulation);
    auto const run = start(*line, schema, program);
    if (!run) return 0;
    int const code = simulation.run(*run, Space());
    if (code > 128) note_how_to_continue(code - 128, *line, schema.list(), program);
    return code;
  }));
}
}  // namespace SCREE_CASES

}  // namespace detail

inline namespace SCREE_CASES {

/// Runs a case program for main(): initialises Kokkos and, if SCREE_MPI is defined (ranks.hpp), MPI, reads the command
/// line and the case, runs `simulate`, and turns an exception into one message. Returns the exit code of `simulate` or
/// an ExitCode.
///
///     int main(int argc, char** argv) { return app::run_program(argc, argv, program, schema(), simulate); }
///
/// Before it writes its first result, `simulate` calls Run::begin() with its solver, which must be ready for the first
/// step. A program that can continue a run has the option Program::restart and uses app::Checkpoints. A study
/// (`--study`, `--vary`) runs `simulate` for one member after the other.
template <class T>
int run_program(int argc, char** argv, Program const& program, Schema<T> const& schema,
                std::type_identity_t<std::function<int(Run<T> const&)>> const& simulate) {
  auto const anywhere = [&](Run<T> const& run, Space const&) { return simulate(run); };
  return detail::run_program(argc, argv, program, schema, detail::Simulation<T>{anywhere, true});
}

/// Runs a case program whose simulation creates its solver on a given instance of the execution space:
/// `int simulate(app::Run<Options> const& run, app::Space const& space)`. A study then runs several members at a time.
template <class T>
int run_program(int argc, char** argv, Program const& program, Schema<T> const& schema,
                std::type_identity_t<std::function<int(Run<T> const&, Space const&)>> const& simulate) {
  return detail::run_program(argc, argv, program, schema, detail::Simulation<T>{simulate});
}

/// Runs a case program that was written for version 0.1 and also passes a function that names the checkpoint. Refuses
/// programs without the option Program::restart: their runs could not tell whether they continue the results that they
/// would replace.
template <class T, class Simulate>
[[deprecated("leave out the last argument: the option with the checkpoint is Program::restart")]] int run_program(
    int argc, char** argv, Program const& program, Schema<T> const& schema, Simulate const& simulate,
    std::type_identity_t<std::function<std::filesystem::path(T const&)>> const&) {
  if (!detail::has_restart(schema.list(), program))
    return guarded_main([]() -> int {
      throw std::logic_error("Program::restart has to name the option with the checkpoint to start from");
    });
  return run_program(argc, argv, program, schema, simulate);
}

}  // namespace SCREE_CASES

}  // namespace scree::app
