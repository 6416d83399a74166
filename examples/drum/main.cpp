// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "schema.hpp"

#include <scree/app/program.hpp>

namespace drum {

template <Scheme scheme>
struct TwoSizes;     // models.hpp
struct ListOfSizes;  // models.hpp
template <int Dim, class Real, class Sizes>
int simulate(app::Run<Options> const& run, app::Space const& space);  // simulate.hpp

template <int Dim, class Real>
int simulate_sizes(app::Run<Options> const& run, app::Space const& space) {
  if (!run.options.species.empty()) return simulate<Dim, Real, ListOfSizes>(run, space);
  if (run.options.segregation.scheme == Scheme::conservative)
    return simulate<Dim, Real, TwoSizes<Scheme::conservative>>(run, space);
  return simulate<Dim, Real, TwoSizes<Scheme::hcsr>>(run, space);
}

}  // namespace drum

int main(int argc, char** argv) {
  using namespace drum;
  auto const simulation = [](app::Run<Options> const& run, app::Space const& space) {
    bool const single = run.options.numerics.precision == Precision::single_precision;
    if (run.options.numerics.dimension == 2)
      return single ? simulate_sizes<2, float>(run, space) : simulate_sizes<2, double>(run, space);
    return single ? simulate_sizes<3, float>(run, space) : simulate_sizes<3, double>(run, space);
  };
  return app::run_program(
      argc, argv,
      {.name = "drum",
       .summary = "Granular flow and particle-size segregation in a rotating drum",
       .results = {"summary.json", "profiles.csv", "radial.csv", "history.csv", "species.csv", "particles.vtkhdf"},
       .profiles = true},
      schema(), simulation);
}
