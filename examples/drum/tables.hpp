// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "moment.hpp"

#include <scree/io/csv_series.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

// Data that a continued run needs: its tables (their columns, and reading them back), and the states that a profile
// averages, also as numbers for a checkpoint.
namespace drum {

/// The names of the concentrations of a list of sizes, "C1" and so on, and their descriptions.
inline std::string name_of_species(int k) { return fmt::format("C{}", k + 1); }
inline constexpr char const* told_of_species[] = {"mean", "min", "max", "core", "surface", "periphery"};

inline std::vector<scree::CsvColumn> species_names(int species) {
  std::vector<scree::CsvColumn> names = {{"time", "s"}};
  for (int k = 0; k < species; ++k)
    for (char const* told : told_of_species) names.emplace_back(fmt::format("{}_{}", name_of_species(k), told));
  return names;
}
inline std::vector<scree::CsvColumn> with_species(std::vector<scree::CsvColumn> names, int species) {
  for (int k = 0; k < species; ++k) names.emplace_back(name_of_species(k));
  return names;
}
inline std::vector<scree::CsvColumn> history_names(int dimension) {
  std::vector<scree::CsvColumn> names;
  for (auto const& column : moment_columns) {
    bool const of_depth = dimension == 2 && column.value == &Moment::kinetic_energy;  // per depth of the plane
    names.emplace_back(column.name, of_depth ? "J/m" : column.unit);
  }
  return names;
}
inline std::vector<scree::CsvColumn> profile_names(int species = 0) {
  std::vector<scree::CsvColumn> names = {{"time", "s"},           {"samples"},        {"angle", "degrees"},
                                         {"surface_height", "m"}, {"bed_depth", "m"}, {"surface_speed", "m/s"},
                                         {"depth_over_D"},        {"particles"}};
  for (auto const& q : profile_quantities) names.emplace_back(q.name, q.unit);
  return with_species(names, species);
}
inline std::vector<scree::CsvColumn> radial_names(int species = 0) {
  return with_species({{"time", "s"}, {"radius", "m"}, "radius_over_R", "particles", "C", "number_density"}, species);
}

/// Numbers of a CSV file by the names in its first line, without their units.
struct Table {
  std::filesystem::path file;
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  bool has(std::string const& name) const { return std::ranges::find(names, name) != names.end(); }
  double value(std::vector<double> const& row, std::string const& name) const {
    if (!has(name)) throw std::runtime_error(file.string() + ": there is no column " + name);
    return row.at(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()));
  }
};
/// Throws std::runtime_error when it cannot be read.
inline Table read_table(std::filesystem::path const& file) {
  std::ifstream stream(file);
  std::string line, cell;
  if (!std::getline(stream, line)) throw std::runtime_error(file.string() + ": cannot read it to continue the run");
  Table table{.file = file, .names = {}, .rows = {}};
  for (std::istringstream header(line); std::getline(header, cell, ',');)
    table.names.push_back(cell.substr(0, cell.find(" [")));
  while (std::getline(stream, line)) {
    std::vector<double> row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');)
      row.push_back(std::strtod(cell.c_str(), nullptr));
    if (row.size() == table.names.size()) table.rows.push_back(row);  // an incomplete row was cut off by a crash
  }
  return table;
}

inline std::vector<double> row_of(Moment const& m) {
  std::vector<double> row;
  for (auto const& column : moment_columns) row.push_back(m.*column.value);
  return row;
}
inline std::vector<double> row_of(Profile const& profile, ProfileRow const& at) {
  std::vector<double> row = {profile.time,
                             profile.samples,
                             profile.angle,
                             profile.height,
                             profile.bed_depth,
                             profile.surface_speed,
                             at.depth / profile.bed_depth,
                             at.particles};
  for (auto const& q : profile_quantities) row.push_back(at.*q.value);
  row.insert(row.end(), at.species.begin(), at.species.end());
  return row;
}

/// The rows of history.csv up to `end` (s). Version 0.1.0 wrote no measures of mixing.
inline std::vector<Moment> read_history(std::filesystem::path const& file, double end) {
  auto const table = read_table(file);
  std::vector<Moment> history;
  for (auto const& row : table.rows) {
    Moment m;
    for (auto const& column : moment_columns) {
      bool const is_new = column.value == &Moment::intensity || column.value == &Moment::lacey;
      m.*column.value = is_new && !table.has(column.name) ? detail::missing() : table.value(row, column.name);
    }
    if (m.time <= end) history.push_back(m);
  }
  return history;
}
/// The profiles up to `end` (s).
inline std::vector<Profile> read_profiles(std::filesystem::path const& file, double end) {
  auto const table = read_table(file);
  std::vector<Profile> profiles;
  for (auto const& row : table.rows) {
    double const time = table.value(row, "time");
    if (time > end) break;
    if (profiles.empty() || profiles.back().time != time)
      profiles.push_back({.time = time,
                          .samples = table.value(row, "samples"),
                          .angle = table.value(row, "angle"),
                          .height = table.value(row, "surface_height"),
                          .bed_depth = table.value(row, "bed_depth"),
                          .surface_speed = table.value(row, "surface_speed")});
    ProfileRow at{.particles = table.value(row, "particles")};
    for (auto const& q : profile_quantities) at.*q.value = table.value(row, q.name);
    for (int k = 0; table.has(name_of_species(k)); ++k) at.species.push_back(table.value(row, name_of_species(k)));
    profiles.back().rows.push_back(at);
  }
  return profiles;
}

/// The contents of the tables of an earlier part of a run.
struct Past {
  std::vector<Moment> moments = {};
  std::vector<Profile> profiles = {};
  std::vector<std::vector<double>> rings = {};    ///< rows of radial.csv
  std::vector<std::vector<double>> species = {};  ///< rows of species.csv
};
/// Profiles belong to the row of history.csv at which they were due, apart from rounding.
inline constexpr double profile_rounding = 1e-9;  // s

/// The tables in a directory up to a time (s); species.csv if there is a list of sizes.
inline Past read_past(std::filesystem::path const& directory, double end, int species = 0) {
  Past past{.moments = read_history(directory / "history.csv", end)};
  double const last = past.moments.empty() ? -1 : past.moments.back().time + profile_rounding;
  past.profiles = read_profiles(directory / "profiles.csv", last);
  auto const rows_until_end = [&](char const* name) {
    auto table = read_table(directory / name);
    std::erase_if(table.rows, [&](auto const& row) { return table.value(row, "time") > last; });
    return table.rows;
  };
  past.rings = rows_until_end("radial.csv");
  if (species > 0) past.species = rows_until_end("species.csv");
  return past;
}

/// The sums over one state.
struct Sample {
  double time = 0;  ///< s
  MidChord chord = {};
  Rings rings = {};

  static Sample of(int species) { return {.chord = MidChord(species), .rings = Rings(species)}; }

  template <class Visitor>
  void visit(Visitor& visitor) {
    visitor(time), chord.visit(visitor), rings.visit(visitor);
  }
};
using Window = std::deque<Sample>;

namespace detail {

struct Pack {
  std::vector<double> numbers = {};
  void operator()(double value) { numbers.push_back(value); }
  template <class List, class Item>
  void size(List const& list, Item const&) {
    numbers.push_back(static_cast<double>(list.size()));
  }
};
struct Unpack {
  std::span<double const> numbers;
  void operator()(double& value) {
    if (numbers.empty()) throw std::runtime_error("the checkpoint does not hold all of the states of a profile");
    value = numbers.front(), numbers = numbers.subspan(1);
  }
  template <class List, class Item>
  void size(List& list, Item const& item) {
    double count = 0;
    operator()(count);
    if (!(count >= 0 && count <= static_cast<double>(numbers.size())))
      throw std::runtime_error("the checkpoint does not hold the states of a profile");
    list.resize(static_cast<std::size_t>(count), item);
  }
};

}  // namespace detail

inline std::vector<double> pack(Window window) {
  detail::Pack pack;
  for (Sample& sample : window) sample.visit(pack);
  return pack.numbers;
}
/// Throws std::runtime_error for numbers that pack() cannot have written.
inline Window unpack(std::span<double const> numbers, int species = 0) {
  Window window;
  for (detail::Unpack unpack{numbers}; !unpack.numbers.empty();) window.emplace_back(Sample::of(species)).visit(unpack);
  return window;
}

}  // namespace drum
