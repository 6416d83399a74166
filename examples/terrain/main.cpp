// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>

#include <string>
#include <vector>

namespace terrain {

template <class Real>
int simulate(app::Run<Options> const& run);  // flow.hpp

}  // namespace terrain

int main(int argc, char** argv) {
  using namespace terrain;
  std::vector<std::string> results = {"summary.json", "history.csv", "particles.vtkhdf", "largest_depth.asc",
                                      "arrival.asc"};
  for (int k = 0; k < most_maps; ++k) results.push_back(name_of_map(k));
  return app::run_program(
      argc, argv, {.name = "terrain", .summary = "Grains released on a terrain", .results = results}, schema(),
      [](app::Run<Options> const& run) {
        return run.options.numerics.precision == Precision::single_precision ? simulate<float>(run)
                                                                             : simulate<double>(run);
      });
}
