// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

namespace silo {
struct TwoSizes;
struct ListOfSizes;
template <int Dim, class Sizes>
int simulate(app::Run<Options> const& run);  // silo.hpp

template <class Sizes>
int simulate_in(app::Run<Options> const& run) {
  return run.options.numerics.dimension == 2 ? simulate<2, Sizes>(run) : simulate<3, Sizes>(run);
}
}  // namespace silo

int main(int argc, char** argv) {
  using namespace silo;
  return app::run_program(argc, argv,
                          {.name = "silo",
                           .summary = "A silo with grains of two or more sizes, whose gate opens",
                           .results = {"summary.json", "history.csv", "particles.vtkhdf"},
                           .profiles = true},
                          schema(), [](app::Run<Options> const& run) {
                            return run.options.species.empty() ? simulate_in<TwoSizes>(run)
                                                               : simulate_in<ListOfSizes>(run);
                          });
}
