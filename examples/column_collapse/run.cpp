// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"
#include "schema.hpp"

#include "../support/start.hpp"

namespace column_collapse {

// Defined in simulate.cpp.
template <int Dim>
void simulate(support::Run<Options> const& run);

/// Reads the case and runs it; returns the exit code of the program.
int run(int argc, char** argv) {
  return support::guarded_main([&] {
    int exit_code = 0;
    auto const run = support::start(
        {argv + 1, argv + argc}, schema(),
        {.name = "column_collapse", .summary = "Collapse of a column of grains", .results = result_files()}, exit_code);
    if (!run) return exit_code;
    run->options.numerics.dimension == 2 ? simulate<2>(*run) : simulate<3>(*run);
    return 0;
  });
}

}  // namespace column_collapse
