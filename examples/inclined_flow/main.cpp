// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/io/write_file.hpp>

namespace inclined_flow {

template <class Real>
int simulate(app::Run<Options> const& run);  // layer.hpp

void report(app::Run<Options> const& run, Outcome const& found) {
  Options const& o = run.options;
  app::Json::Object summary = {{"angle", o.slope.angle},
                               {"rows", o.numerics.rows},
                               {"settling_time", found.settling_time},
                               {"granular_viscosity", found.granular_viscosity},
                               {"mean_velocity_ratio", found.ratio},
                               {"deviation_of_core", found.deviation}};
  app::add_counts(summary, found.figures, found.wall_seconds);
  app::add_packing(summary, found.figures.packing);
  scree::write_file(run.output / "summary.json", app::to_json(summary));
  if (!run.quiet)
    app::say(stdout,
             "core at most {:.2f} % off Bagnold's profile\n"
             "results in {}\n",
             100 * found.deviation, run.output.string());
}

}  // namespace inclined_flow

int main(int argc, char** argv) {
  using namespace inclined_flow;
  return app::run_program(argc, argv,
                          {.name = "inclined_flow",
                           .summary = "Steady flow of grains down a rough slope",
                           .results = {"summary.json", "profile.csv", "history.csv", "particles.vtkhdf"},
                           .profiles = true},
                          schema(), simulate<double>);
}
