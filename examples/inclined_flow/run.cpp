// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"
#include "schema.hpp"

#include "../support/start.hpp"

namespace inclined_flow {
// Defined in simulate.cpp.

void simulate(support::Run<Options> const& run);

/// Reads the case and runs it; returns the exit code of the program.
int run(int argc, char** argv) {
  return support::guarded_main([&] {
    int exit_code = 0;
    auto const run = support::start(
        {argv + 1, argv + argc}, schema(),
        {.name = "inclined_flow", .summary = "Steady flow of grains down a rough slope", .results = result_files()},
        exit_code);
    if (!run) return exit_code;
    simulate(*run);
    return 0;
  });
}

}  // namespace inclined_flow
