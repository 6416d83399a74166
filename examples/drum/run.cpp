// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"
#include "schema.hpp"

#include <scree/app/start.hpp>

namespace drum {

// Defined in simulate_*.cpp.
template <int Dim, class Real>
int simulate(scree::app::Run<Options> const& run);

/// Reads the case and runs it; returns the exit code of the program.
int run(int argc, char** argv) {
  return scree::app::guarded_main([&] {
    int exit_code = 0;
    auto const run =
        scree::app::start({argv + 1, argv + argc}, schema(),
                          {.name = "drum",
                           .summary = "Granular flow and particle-size segregation in a rotating drum",
                           .results = result_files()},
                          exit_code, [](Options const& o) { return std::filesystem::path(o.time.restart_from); });
    if (!run) return exit_code;
    bool const in_plane = run->options.numerics.dimension == 2;
    bool const single = run->options.numerics.precision == Precision::single_precision;
    if (in_plane) return single ? simulate<2, float>(*run) : simulate<2, double>(*run);
    return single ? simulate<3, float>(*run) : simulate<3, double>(*run);
  });
}

}  // namespace drum
