// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

namespace footing_and_wheel {
template <class Real>
int simulate(app::Run<Options> const& run);  // bed.hpp
}

int main(int argc, char** argv) {
  using namespace footing_and_wheel;
  return app::run_program(argc, argv,
                          {.name = "footing_and_wheel",
                           .summary = "A rigid strip that is pressed into soil, or a driven wheel on it",
                           .results = {"summary.json", "history.csv", "particles.vtkhdf"}},
                          schema(), [](app::Run<Options> const& run) { return simulate<double>(run); });
}
