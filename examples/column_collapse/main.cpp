// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "case.hpp"

#include <scree/app/program.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/io/write_file.hpp>

namespace column_collapse {

template <int Dim>
int simulate(app::Run<Options> const& run);  // column.hpp

void report(app::Run<Options> const& run, Outcome const& found) {
  Options const& o = run.options;
  double const L0 = o.geometry.width, a = o.geometry.aspect, run_out = found.reach / L0 - 1;
  Band const band = run_out_band(o.numerics.dimension, a);
  app::Json::Object summary = {{"aspect", a},
                               {"dimension", o.numerics.dimension},
                               {"across", o.numerics.across},
                               {"run_out", run_out},
                               {"run_out_least", band.least},
                               {"run_out_greatest", band.greatest},
                               {"summit_over_L0", found.summit / L0},
                               {"largest_speed", found.largest_speed}};
  app::add_counts(summary, found.figures, found.wall_seconds);
  app::add_packing(summary, found.figures.packing);
  scree::write_file(run.output / "summary.json", app::to_json(summary));
  if (!run.quiet)
    app::say(stdout,
             "run-out {:.3f} L0 at a depth of {} H0; experiments {:.3f} to {:.3f}; summit {:.3f} L0\nresults in {}\n",
             run_out, o.output.reading_depth, band.least, band.greatest, found.summit / L0, run.output.string());
}

}  // namespace column_collapse

int main(int argc, char** argv) {
  using namespace column_collapse;
  return app::run_program(argc, argv,
                          {.name = "column_collapse",
                           .summary = "Collapse of a column of grains",
                           .results = {"summary.json", "profile.csv", "history.csv", "particles.vtkhdf"},
                           .profiles = true},
                          schema(), [](app::Run<Options> const& run) {
                            return run.options.numerics.dimension == 2 ? simulate<2>(run) : simulate<3>(run);
                          });
}
