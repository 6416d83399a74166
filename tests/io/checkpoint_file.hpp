// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/io/checkpoint.hpp>

#include <support/folder.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

// Snapshots and files for tests of checkpoints.
namespace checkpoint_test {

namespace fs = std::filesystem;

template <class T>
scree::SnapshotArray array_of(std::string name, int components, std::vector<T> const& values) {
  scree::SnapshotArray array{std::move(name), "m/s", scree::element_type<T>(), components, {}};
  array.bytes.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
  return array;
}

/// A snapshot with everything that could get lost: NaN, no values, no text, odd names.
inline scree::Snapshot odd_snapshot() {
  scree::Snapshot snapshot;
  snapshot.signature = "dimension: 2\nprecision: float64\n";
  snapshot.time = 0.1 + 0.2;
  snapshot.steps = 123456789012;
  snapshot.counters = {{"step limits/sound", 7}, {"neighbour builds/material-wall", 0}, {"a: b", -1}};
  snapshot.notes = {{"case", "size = 1 # Größe\n"}, {"empty", ""}, {"long", std::string(100'000, 'x')}};
  double const infinity = std::numeric_limits<double>::infinity();
  snapshot.arrays = {array_of<double>("material/velocity", 2, {1, -0.0, std::nan("7"), -infinity, 5e-324, 1.0 / 3}),
                     array_of<float>("material/a name (2)", 1, {1, -0.0f, std::nanf("3")}),
                     array_of<std::int32_t>("wall/identity", 1, {1, -2, 2147483647}),
                     array_of<double>("wall/none", 3, {}), array_of<double>("a first one", 1, {1})};
  return snapshot;
}
/// odd_snapshot() with a time (s) that distinguishes it from others.
inline scree::Snapshot snapshot_at(double time) {
  auto snapshot = odd_snapshot();
  snapshot.time = time;
  return snapshot;
}

inline void set_content(fs::path const& file, std::string const& content) {
  std::ofstream(file, std::ios::binary) << content;
}
inline std::vector<std::string> files_in(fs::path const& folder) {
  std::vector<std::string> names;
  for (auto const& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The message that an action throws; empty if it does not throw.
template <class Action>
std::string complaint_of(Action action) {
  try {
    action();
  } catch (std::runtime_error const& error) {
    return error.what();
  }
  return "";
}
inline std::string complaint_about(fs::path const& file) {
  return complaint_of([&] { scree::read_checkpoint(file); });
}

/// Soft limit on the size of files this process may write, for as long as it lives.
struct FileSizeLimit {
  ::rlimit before{};
  explicit FileSizeLimit(std::uintmax_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before);
    ::rlimit const now{.rlim_cur = bytes, .rlim_max = before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before); }
};

}  // namespace checkpoint_test
