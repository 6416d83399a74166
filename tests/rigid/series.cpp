// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/rigid_series.hpp>

#include <support/folder.hpp>
#include <support/rigid_bodies.hpp>

#include <catch2/catch_test_macros.hpp>

#include <fstream>
#include <sstream>

// Tables of the states of rigid bodies.
namespace scree::test::series_tests {
namespace {
std::vector<std::vector<double>> rows_of(std::filesystem::path const& file, std::string& header) {
  std::ifstream stream(file);
  std::getline(stream, header);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}
template <int Dim>
void check_table(std::string const& expected) {
  using F = Free<Policy<Dim, double, Kokkos::DefaultHostExecutionSpace>>;
  using X = Vec<Dim, double>;
  Groups<Dim> stones;
  RigidBodies<Dim> rigid;
  for (double const place : {0.0, 1.0}) {
    Rigid<Dim> body;
    body.properties = {2, place * X::Unit(0), 0.5 * Inertia<Dim>::Identity()};
    body.angular_velocity[0] = 0.3;
    rigid.bodies.push_back(body);
    stones.add(place == 0 ? "left" : "right", {place * X::Unit(0)});
  }
  Spring<Dim> spring;
  spring.body = 1, spring.point = X::Unit(0), spring.stiffness = 50, spring.length = 0.9;
  rigid.springs.push_back(spring);
  auto const make = [&] {
    return Solver<F>({.spacing = 0.1, .physics = {.gravity = {10}}, .rigid = rigid, .start_checks = false},
                     particles_of<Material>(std::vector<X>()), particles_of<Block>(stones));
  };
  auto solver = make();
  Folder const folder;
  RigidSeries series(folder / "stones", stones);
  for (int k = 0; k < 3; ++k) series.append(solver), solver.step(0.01);
  std::string header;
  auto const rows = rows_of(folder / "stones" / "right.csv", header);
  CHECK(header == expected);
  REQUIRE(rows.size() == 3);
  CHECK(rows[2].size() == RigidSeries<Dim>::columns().size());
  CHECK(rows[2][0] == 0.02);
  CHECK(rows[2][1] < 1);  // the spring pulls
  std::size_t const of_spring = rows[2].size() - Dim - (Dim == 2 ? 1 : 3);
  CHECK(rows[2][of_spring] < -4);
  CHECK(rows_of(folder / "stones" / "left.csv", header)[2][of_spring] == 0);
  // A restart at 0.01 s drops what came later.
  RigidSeries again(folder / "stones", stones, 0.01);
  again.append(solver);
  auto const continued = rows_of(folder / "stones" / "right.csv", header);
  REQUIRE(continued.size() == 3);
  CHECK(continued[1] == rows[1]);
  CHECK(continued[2][0] == 0.03);
}
}  // namespace

TEST_CASE("the states of rigid bodies are written to a table each") {
  check_table<2>(
      "time [s],position x [m],position z [m],velocity x [m/s],velocity z [m/s],attitude [rad],angular velocity "
      "[rad/s],force of grains x [N],force of grains z [N],moment of grains [N m],force of contacts x [N],force of "
      "contacts z [N],moment of contacts [N m],force of springs x [N],force of springs z [N],moment of springs [N m]");
  check_table<3>(
      "time [s],position x [m],position y [m],position z [m],velocity x [m/s],velocity y [m/s],velocity z "
      "[m/s],attitude 0,attitude 1,attitude 2,attitude 3,angular velocity x [rad/s],angular velocity y "
      "[rad/s],angular velocity z [rad/s],force of grains x [N],force of grains y [N],force of grains z [N],moment of "
      "grains x [N m],moment of grains y [N m],moment of grains z [N m],force of contacts x [N],force of contacts y "
      "[N],force of contacts z [N],moment of contacts x [N m],moment of contacts y [N m],moment of contacts z [N "
      "m],force of springs x [N],force of springs y [N],force of springs z [N],moment of springs x [N m],moment of "
      "springs y [N m],moment of springs z [N m]");
}

}  // namespace scree::test::series_tests
