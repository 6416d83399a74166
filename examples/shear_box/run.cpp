// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"
#include "schema.hpp"

#include <scree/app/start.hpp>

namespace shear_box {

// Defined in simulate_*.cpp.
template <int Dim, class Real>
void simulate(scree::app::Run<Options> const& run);

/// Reads the case and runs it; returns the exit code of the program.
int run(int argc, char** argv) {
  return scree::app::guarded_main([&] {
    int exit_code = 0;
    auto const run = scree::app::start({argv + 1, argv + argc}, schema(),
                                       {.name = "shear_box",
                                        .summary = "Particle-size segregation in an oscillating shear box",
                                        .results = result_files()},
                                       exit_code);
    if (!run) return exit_code;
    bool const in_plane = run->options.numerics.dimension == 2;
    bool const single = run->options.numerics.precision == Precision::single_precision;
    if (in_plane)
      single ? simulate<2, float>(*run) : simulate<2, double>(*run);
    else
      single ? simulate<3, float>(*run) : simulate<3, double>(*run);
    return 0;
  });
}

}  // namespace shear_box
