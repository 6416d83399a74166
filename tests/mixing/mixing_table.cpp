// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bed.hpp"

#include <support/folder.hpp>

#include <scree/mixing/mixing_table.hpp>

#include <catch2/catch_test_macros.hpp>

#include <string>

namespace scree::test::mixing_table_tests {
using namespace fields;
using namespace mixing;
namespace {

struct Full : MixedBed<2, double, Fields<StartPosition, Concentrations<3>>> {
  using diagnostics = NeighbourMixing<SpeciesOf<3>>;
};
std::string header_of(std::vector<CsvColumn> const& columns) {
  std::string all;
  for (auto const& each : columns) all += each.header() + ";";
  return all;
}

}  // namespace

TEST_CASE("a table of mixing has the measures that a formulation can give") {
  using Plain = Solver<MixedBed<2>>;
  CHECK(header_of(mixing_columns<Plain>()) == "time [s];share;intensity;lacey;samples;");
  CHECK(header_of(mixing_columns<Solver<Full>>()) ==
        "time [s];share 1;share 2;intensity;lacey;samples;neighbours;doucet;");

  auto const points = fill_lattice(Box<2>{{0, 0}, {1, 1}}, 0.05);
  Solver<Full> bed({.spacing = 0.05, .physics = {}, .start_checks = false}, points);
  mark_start(bed);
  bed.set(concentrations<3>, [](auto const& x) { return Vec<3, double>(x[0] < 0.2 ? 1 : 0, 0, x[0] < 0.2 ? 0 : 1); });
  auto const row = mixing_row(bed, {.cell = 0.1});
  REQUIRE(row.size() == mixing_columns<Solver<Full>>().size());
  CHECK(std::abs(row[1] - 0.2) < 1e-12);
  CHECK(row[2] == 0);
  CHECK(row[3] == segregation_intensity(bed).value);
  CHECK(row[4] == lacey_index(bed, {.cell = 0.1}).index);
  CHECK(row[5] == 100);
  CHECK(row[6] == neighbour_index(bed).value);
  CHECK(std::abs(row[7] - 1) < 1e-12);

  Folder const folder;
  auto plain = unit_bed<2>(10);
  plain.set(concentration, [](auto const& x) { return x[1]; });
  {
    CsvSeries table(folder / "mixing.csv", mixing_columns<Plain>());
    table.row(mixing_row(plain));
  }
  auto const text = content_of(folder / "mixing.csv");
  CHECK(text.substr(0, text.find('\n')) == "time [s],share,intensity,lacey,samples");
}

}  // namespace scree::test::mixing_table_tests
