// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

namespace silo {
template <int Dim>
int simulate(app::Run<Options> const& run);  // silo.hpp
}

int main(int argc, char** argv) {
  using namespace silo;
  return app::run_program(argc, argv,
                          {.name = "silo",
                           .summary = "A silo with two sizes of grains, whose gate opens",
                           .results = {"summary.json", "history.csv", "particles.vtkhdf"},
                           .profiles = true},
                          schema(), [](app::Run<Options> const& run) {
                            return run.options.numerics.dimension == 2 ? simulate<2>(run) : simulate<3>(run);
                          });
}
