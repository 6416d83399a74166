// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

namespace blender {
template <class Real>
int simulate(app::Run<Options> const& run);  // blender.hpp
}

int main(int argc, char** argv) {
  using namespace blender;
  return app::run_program(argc, argv,
                          {.name = "blender",
                           .summary = "Two sizes of grains in a tumbling vessel from an STL file",
                           .results = {"summary.json", "history.csv", "particles.vtkhdf"}},
                          schema(), [](app::Run<Options> const& run) {
                            bool const single = run.options.numerics.precision == Precision::single_precision;
                            return single ? simulate<float>(run) : simulate<double>(run);
                          });
}
