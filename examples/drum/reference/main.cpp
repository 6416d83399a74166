// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "maps.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

// Grain by grain: cases EV and EN in a periodic slice of a rough drum, several seeds at once; README.md says more.
namespace {

using namespace grains;

struct Options {
  std::vector<std::pair<std::string, int>> replicas = {};  // case, seed
  std::string output;
  double time = 20;         // of rotation, s
  double settle = 0.1;      // before it, s
  double wall_limit = 1e9;  // wall clock, s
  double step = 6.5e-6, skin = 0.06e-3, radius = 0.035, length = 0.003, rpm = 5;
  double sample = 4e-3, frame = 0.25, window = 1;
  Material material = {};
};

Options read(int argc, char** argv) {
  Options o;
  std::ostringstream names;
  for (int k = 1; k < argc; ++k) {
    std::string const text = argv[k];
    auto const equals = text.find('=');
    std::string const name = text.substr(0, equals), value = equals == std::string::npos ? "" : text.substr(equals + 1);
    auto const number = [&] {
      char* end = nullptr;
      double const x = std::strtod(value.c_str(), &end);
      if (value.empty() || *end != 0 || !(x >= 0))
        throw std::runtime_error(name + " needs a number that is not negative");
      return x;
    };
    std::pair<char const*, double*> const numbers[] = {{"time", &o.time},
                                                       {"settle", &o.settle},
                                                       {"wall_limit", &o.wall_limit},
                                                       {"step", &o.step},
                                                       {"skin", &o.skin},
                                                       {"radius", &o.radius},
                                                       {"length", &o.length},
                                                       {"rpm", &o.rpm},
                                                       {"sample", &o.sample},
                                                       {"frame", &o.frame},
                                                       {"window", &o.window},
                                                       {"modulus", &o.material.modulus},
                                                       {"restitution", &o.material.restitution},
                                                       {"friction", &o.material.friction},
                                                       {"density", &o.material.density}};
    bool known = false;
    for (auto const& [key, target] : numbers)
      if (name == key) *target = number(), known = true;
    if (name == "output") o.output = value, known = true;
    if (name == "ev" || name == "en") {
      std::istringstream seeds(value);
      for (std::string seed; std::getline(seeds, seed, ',');) {
        char* end = nullptr;
        long const n = std::strtol(seed.c_str(), &end, 10);
        if (seed.empty() || *end != 0 || n < 1 || n > 1000000)
          throw std::runtime_error("a seed is a whole number from 1 to 1000000");
        o.replicas.emplace_back(name, int(n));
      }
      known = true;
    }
    if (!known)
      throw std::runtime_error(
          "unknown argument " + text +
          "; there are ev=SEED,..., en=SEED,..., output=DIR, time, settle, wall_limit, step, skin, radius, "
          "length, rpm, sample, frame, window, modulus, restitution, friction, density");
  }
  auto const finite = [](char const* name, double value) {
    if (!(value > 0 && std::isfinite(value)))
      throw std::runtime_error(std::string(name) + " must be above 0 and finite");
  };
  finite("time", o.time), finite("sample", o.sample), finite("frame", o.frame), finite("window", o.window);
  finite("step", o.step), finite("skin", o.skin), finite("density", o.material.density);
  finite("modulus", o.material.modulus);
  if (o.replicas.empty() || o.output.empty())
    throw std::runtime_error("needs output=DIR and ev=SEED,... or en=SEED,...");
  return o;
}

Filling filling_of(Options const& o, std::string const& name, int seed) {
  Filling f{.drum_radius = o.radius, .length = o.length, .seed = std::uint32_t(seed)};
  if (name == "en") f.fill_depth = 0.591, f.share_small = 1.0 / 9, f.seed += 500000;
  return f;
}

void write(std::ofstream& file, std::vector<float> const& values) {
  file.write(reinterpret_cast<char const*>(values.data()), std::streamsize(values.size() * sizeof(float)));
  file.flush();
  if (!file) throw std::runtime_error("cannot write the results");
}

void write_grains(std::filesystem::path const& path, Bed const& bed) {
  std::ofstream file(path);
  file << "replica,kind,x,y,z\n";
  for (Grain const& g : bed.grains()) {
    if (g.kind == glued) continue;
    char line[100];
    std::snprintf(line, sizeof line, "%d,%d,%.3f,%.3f,%.3f\n", g.replica, g.kind, 1e3 * g.x[0], 1e3 * g.x[1],
                  1e3 * g.x[2]);
    file << line;
  }
}

void run(Options const& o) {
  double const pi = std::numbers::pi;
  std::filesystem::path const output = o.output;
  std::filesystem::create_directories(output);
  std::vector<Grain> all;
  Filling some;
  for (std::size_t k = 0; k < o.replicas.size(); ++k) {
    some = filling_of(o, o.replicas[k].first, o.replicas[k].second);
    auto const grains = fill(some, int(k));
    all.insert(all.end(), grains.begin(), grains.end());
  }
  double const r = some.large_radius, outer = o.radius + 2.4 * r;
  Settings const settings{.kinds = {{.radius = r}, {.radius = r / 2}, {.radius = r, .glued = true}},
                          .material = o.material,
                          .drum_radius = outer,
                          .length = o.length,
                          .range = outer + 2 * r,
                          .step = o.step,
                          .skin = o.skin,
                          .replicas = int(o.replicas.size())};
  Bed bed(settings, all);
  Maps window(o.radius + 1e-3, 0.5e-3, settings.replicas), frame(o.radius + 1e-3, 1e-3, settings.replicas, 2);
  std::ofstream windows(output / "windows.f32", std::ios::binary), frames(output / "frames.f32", std::ios::binary);
  std::ofstream log(output / "log.csv"), list(output / "windows.csv");
  log << "time (s),steps,wall (s),rebuilds,late rebuilds,kinetic energy (J),mean overlap,largest overlap,contacts,in "
         "the wall,lost\n";
  list << "from (s),to (s),samples\n";
  {
    std::ofstream about(output / "about.txt");
    about << "replicas";
    for (auto const& [name, seed] : o.replicas) about << " " << name << ":" << seed;
    about << "\ngrains " << bed.mobile() << " of " << bed.size() << "\nacross " << window.across() << " "
          << frame.across() << "\nradius " << o.radius << "\nlength " << o.length << "\nrpm " << o.rpm << "\nstep "
          << o.step << "\nskin " << o.skin << "\nmodulus " << o.material.modulus << "\nrestitution "
          << o.material.restitution << "\nfriction " << o.material.friction << "\ndensity " << o.material.density
          << "\ncollision time of small grains " << collision_time(o.material, r / 2) << "\nspace " << Space::name()
          << "\n";
  }
  auto const start = std::chrono::steady_clock::now();
  auto const clock = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  auto const steps_in = [&](double time) { return std::max(1L, std::lround(time / o.step)); };
  double const begin = double(steps_in(o.settle)) * o.step;
  auto const report = [&] {
    Kokkos::fence();
    auto const overlaps = bed.overlaps();
    auto const l = losses(bed, o.radius, outer);
    char line[300];
    std::snprintf(line, sizeof line, "%.4f,%ld,%.2f,%ld,%ld,%.4e,%.3e,%.3e,%.3f,%ld,%ld", bed.time() - begin,
                  bed.steps(), clock(), bed.rebuilds(), bed.late_rebuilds(), bed.kinetic_energy(), overlaps.mean,
                  overlaps.largest, overlaps.contacts, l.in_wall, l.lost);
    log << line << std::endl;
    std::cout << line << std::endl;
    if (!std::isfinite(bed.kinetic_energy())) throw std::runtime_error("the kinetic energy is not finite");
    if (l.lost > 0) throw std::runtime_error(std::to_string(l.lost) + " grains left the drum");
  };
  report();
  bed.advance(steps_in(o.settle));
  report();
  frame.add(bed);
  write(frames, frame.take());
  bed.set_rotation(o.rpm * 2 * pi / 60);
  long const sample = steps_in(o.sample), per_frame = std::max(1L, std::lround(o.frame / o.sample)),
             per_window = std::max(1L, std::lround(o.window / o.sample)), samples = std::lround(o.time / o.sample);
  double from = bed.time() - begin;
  for (long k = 1; k <= samples; ++k) {
    bed.advance(sample);
    window.add(bed);
    bool const out_of_time = k % 50 == 0 && clock() > o.wall_limit;
    if (k % per_frame == 0) {
      frame.add(bed);
      write(frames, frame.take());
      report();
    }
    if (k % per_window == 0 || k == samples || out_of_time) {
      list << from << "," << bed.time() - begin << "," << window.samples() << std::endl;
      from = bed.time() - begin;
      write(windows, window.take());
    }
    if (out_of_time) break;
  }
  report();
  write_grains(output / "grains.csv", bed);
}

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const guard(argc, argv);
  try {
    run(read(argc, argv));
  } catch (std::exception const& e) {
    std::cerr << "drum_reference: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
