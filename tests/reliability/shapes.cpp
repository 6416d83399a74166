// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R23: meshes of one to five closed shells that touch, overlap or enclose each other.
#include "tally.hpp"

#include <scree/setup/lattice.hpp>
#include <scree/setup/mesh/read_mesh.hpp>

#include <setup/mesh/shells.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace scree::test::shapes_tests {
using namespace shells;
namespace {

/// The first question that a mesh of shells answers differently from their planes, or "".
std::string fault_of_union(std::vector<Convex> const& parts, int kind, Random& random, long& points) {
  Triangles const all = joined(parts);
  Mesh const mesh(kind == 0   ? read_stl(ascii_stl(all), "a.stl")
                  : kind == 1 ? read_stl(binary_stl(all), "b.stl")
                              : read_obj(obj(all), "c.obj"));
  auto walk = mesh.walk();
  double const dr = 0.33, reach = 1.98;
  Box<3> const around{{-reach, -reach, -reach}, {reach, reach, reach}};
  X3 const anchor = mesh.bounds().low;
  long filled = 0, on_planes = 0, other_side = 0, other_walk = 0, not_exact = 0, across = 0;
  for (X3 const& x : fill_lattice(around, dr, anchor)) {
    bool const inside = mesh.contains(x);
    double const distance = mesh.signed_distance(x);
    other_side += (distance < 0) != inside, other_walk += (walk(x) < 0) != inside;
    auto const exact = is_within(parts, x);
    filled += exact == true, on_planes += !exact, ++points;
    not_exact += exact && *exact != inside;
    // No point of the ball that the distance promises is on the other side.
    if (!exact || random.whole(0, 3) > 0) continue;
    auto const near = is_within(parts, x + 0.999 * std::abs(distance) * random.point().normalized());
    across += near && *near != *exact;
  }
  long const found = long(fill_lattice(mesh & around, dr, anchor).size());
  std::string const counts = std::to_string(parts.size()) + " shells: ";
  if (not_exact > 0) return counts + std::to_string(not_exact) + " points on the wrong side";
  if (other_side + other_walk > 0) return counts + "signed_distance or walk of another side than contains";
  if (across > 0) return counts + "the surface is nearer than signed_distance says";
  if (found < filled || found > filled + on_planes)
    return counts + std::to_string(found) + " particles, " + std::to_string(filled) + " to " +
           std::to_string(filled + on_planes) + " expected";
  return "";
}

}  // namespace

TEST_CASE("random unions of closed shells are filled and measured as their planes say", "[R23]") {
  Tally tally("R23");
  Random random{random_of(23)};
  long points = 0, refused = 0;
  int const number = attempts(20, 1000);
  for (int k = 0; k < number; ++k) {
    auto const parts = random_shells(random);
    try {
      tally.count(fault_of_union(parts, k % 3, random, points));
    } catch (std::exception const& error) {
      std::string const said = error.what();
      bool const is_explained = said.find("their union could not be formed") != std::string::npos ||
                                said.find("shells that touch at an edge have unlike orientations") != std::string::npos;
      tally.count(is_explained ? "" : "refused: " + said);
      ++refused;
    }
  }
  // Nearly one in a thousand, most of them in binary STL, whose rounding parts faces that touched.
  tally.count(refused <= std::max(2, number / 100) ? "" : std::to_string(refused) + " files are refused");
  tally.note("STL and OBJ in turn, " + std::to_string(refused) + " refused, " + std::to_string(points) + " points");
}

}  // namespace scree::test::shapes_tests
