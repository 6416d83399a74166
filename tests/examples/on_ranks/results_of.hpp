// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../io/hdf5_file.hpp"

#include <scree/app/start.hpp>

#include <support/folder.hpp>

#include <catch2/catch_test_macros.hpp>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

// The results of a run as one text, without times of the clock.

/// Runs a case, which must end well, in a folder that it makes.
template <class Options>
void run_in(std::filesystem::path const& output, Options const& options,
            int (*simulate)(scree::app::Run<Options> const&)) {
  std::filesystem::create_directories(output);
  REQUIRE(simulate({.options = options, .output = output, .quiet = true}) == 0);
}

/// A table without the column `wall_seconds`.
inline std::string table_in(std::filesystem::path const& file) {
  std::istringstream lines(content_of(file));
  std::string line, cell, text;
  std::size_t clock = std::string::npos;
  for (bool first = true; std::getline(lines, line); first = false) {
    std::istringstream cells(line);
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (first && cell.starts_with("wall_seconds")) clock = k;
      if (k != clock) text += cell + ',';
    }
    text += '\n';
  }
  return text;
}
/// A JSON file without the lines that name seconds.
inline std::string summary_in(std::filesystem::path const& file) {
  std::istringstream lines(content_of(file));
  std::string line, text;
  while (std::getline(lines, line))
    if (line.find("second") == std::string::npos) text += line + '\n';
  return text;
}
/// HDF5 files contain the time at which they were written.
inline std::string series_in(std::filesystem::path const& file) {
  File const series(file);
  std::string text;
  int found = 0;
  for (std::string const name : {"Steps/Values", "Points", "PointData/velocity", "PointData/concentration",
                                 "PointData/concentration_1", "PointData/concentration_3"}) {
    // A mixture of two sizes or one of a list.
    if (H5Lexists(series.id, ("VTKHDF/" + name).c_str(), H5P_DEFAULT) <= 0) continue;
    ++found;
    auto const values = series.read<double>("VTKHDF/" + name);
    text.append(reinterpret_cast<char const*>(values.data()), values.size() * sizeof(values[0]));
  }
  REQUIRE(found >= 4);
  return text;
}

template <class... Names>
std::string results_of(std::filesystem::path const& folder, Names const&... names) {
  std::string text;
  for (std::filesystem::path const name : {names...})
    text += name.extension() == ".csv"    ? table_in(folder / name)
            : name.extension() == ".json" ? summary_in(folder / name)
                                          : series_in(folder / name);
  return text;
}
