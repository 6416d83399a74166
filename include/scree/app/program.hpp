// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "start.hpp"
#include "streams.hpp"

#include <Kokkos_Core.hpp>

namespace scree::app {

/// The main() of a case program: initialises Kokkos, reads the command line and the case, runs `simulate`, and turns
/// what it throws into one message. Returns the exit code: that of `simulate`, or an ExitCode.
///
///     int main(int argc, char** argv) { return app::run_program(argc, argv, program, schema(), simulate); }
///
/// `simulate` calls Run::begin() before it writes its first result. `checkpoint_of` tells from the options which
/// checkpoint a run starts from, if the program can go on from one.
template <class T>
int run_program(int argc, char** argv, Program const& program, Schema<T> const& schema,
                std::type_identity_t<std::function<int(Run<T> const&)>> const& simulate,
                std::type_identity_t<CheckpointOf<T>> const& checkpoint_of = {}) {
  guard_streams();
  Kokkos::ScopeGuard const kokkos(argc, argv);
  return guarded_main([&] {
    int exit_code = 0;
    auto const run = start({argv + 1, argv + argc}, schema, program, exit_code, checkpoint_of);
    return run ? simulate(*run) : exit_code;
  });
}

}  // namespace scree::app
