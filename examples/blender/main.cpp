// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

namespace blender {
struct TwoSizes;
struct ListOfSizes;
template <class Real, class Sizes>
int simulate(app::Run<Options> const& run);  // blender.hpp

template <class Sizes>
int simulate_in(app::Run<Options> const& run) {
  bool const single = run.options.numerics.precision == Precision::single_precision;
  return single ? simulate<float, Sizes>(run) : simulate<double, Sizes>(run);
}
}  // namespace blender

int main(int argc, char** argv) {
  using namespace blender;
  return app::run_program(argc, argv,
                          {.name = "blender",
                           .summary = "Grains of two or more sizes in a tumbling vessel from an STL file",
                           .results = {"summary.json", "history.csv", "particles.vtkhdf"}},
                          schema(), [](app::Run<Options> const& run) {
                            return run.options.species.empty() ? simulate_in<TwoSizes>(run)
                                                               : simulate_in<ListOfSizes>(run);
                          });
}
