// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../bed.hpp"
#include "../filling.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

// Two cases that LAMMPS computes too, with two_grains.in and small_drum.in: writes their starts and own results to a
// folder.
namespace {

using namespace grains;

constexpr double radius = 0.25e-3;

void write_start(std::string const& path, std::vector<Grain> const& all, Settings const& o) {
  std::ofstream file(path);
  file.precision(17);
  file << "grains\n\n"
       << all.size() << " atoms\n2 atom types\n\n"
       << -o.range << " " << o.range << " xlo xhi\n0 " << o.length << " ylo yhi\n"
       << -o.range << " " << o.range << " zlo zhi\n\nAtoms # sphere\n\n";
  auto const line = [&](std::size_t k, auto... values) { file << k + 1, ((file << " " << values), ...), file << "\n"; };
  for (std::size_t k = 0; k < all.size(); ++k)
    line(k, all[k].kind == glued ? 2 : 1, 2 * radius, o.material.density, all[k].x[0], all[k].x[1], all[k].x[2]);
  file << "\nVelocities\n\n";
  for (std::size_t k = 0; k < all.size(); ++k)
    line(k, all[k].v[0], all[k].v[1], all[k].v[2], all[k].spin[0], all[k].spin[1], all[k].spin[2]);
}

void two_grains(std::string const& folder, Settings const& o) {
  std::vector<Grain> const two{
      {.x = {0, 1e-3, 0}, .v = {0.05, 0.01, -0.02}, .spin = {20, -50, 30}},
      {.x = {1.9 * radius, 1e-3 + 0.6 * radius, 0.5 * radius}, .v = {-0.1, 0.02, 0.01}, .spin = {-100, 40, 200}}};
  write_start(folder + "/two_grains.data", two, o);
  Bed bed(o, two);
  bed.advance(600);
  for (auto const& g : bed.grains())
    std::printf("%.6g %.6g %.6g %.6g %.6g %.6g\n", g.v[0], g.v[1], g.v[2], g.spin[0], g.spin[1], g.spin[2]);
}

void small_drum(std::string const& folder, Settings o) {
  Filling const f{.drum_radius = 7.6e-3, .share_small = 0};
  o.gravity = {0, 0, -9.81};
  o.drum_radius = f.drum_radius + 2.4 * radius, o.length = f.length, o.range = o.drum_radius + 2 * radius,
  o.step = 1.25e-5;
  Bed settling(o, fill(f, 0));
  settling.advance(8000);
  auto const start = settling.grains();
  write_start(folder + "/small_drum.data", start, o);
  Bed bed(o, start);
  bed.set_rotation(2 * std::numbers::pi / 3);
  double const m = mass(o.material, radius);
  std::ofstream table(folder + "/small_drum.csv");
  table << "time (s),x (m),z (m),kinetic energy (J),mean speed (m/s),contacts\n";
  for (int sample = 0; sample < 50; ++sample) {
    bed.advance(1600);
    double x = 0, z = 0, energy = 0, speed = 0;
    for (auto const& g : bed.grains()) {
      if (g.kind == glued) continue;
      double const now = std::hypot(g.v[0], g.v[1], g.v[2]);
      x += g.x[0], z += g.x[2], energy += m * now * now / 2, speed += now;
    }
    int const n = bed.mobile();
    table << bed.time() << "," << x / n << "," << z / n << "," << energy << "," << speed / n << ","
          << bed.overlaps().contacts << std::endl;
  }
}

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const guard(argc, argv);
  if (argc != 2) {
    std::cerr << "usage: drum_reference_lammps FOLDER\n";
    return 1;
  }
  Settings const o{.kinds = {{.radius = radius}, {.radius = radius / 2}, {.radius = radius, .glued = true}},
                   .material = {},
                   .gravity = {0, 0, 0},
                   .drum_radius = 4e-3,
                   .length = 4e-3,
                   .range = 4.5e-3,
                   .step = 1e-6,
                   .skin = 0.06e-3};
  two_grains(argv[1], o);
  small_drum(argv[1], o);
  return 0;
}
