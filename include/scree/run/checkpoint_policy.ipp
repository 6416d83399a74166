// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "checkpoint_policy.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace scree {

SCREE_BODY CheckpointPolicy::CheckpointPolicy(CheckpointOptions options, CheckpointFiles files)
    : options_(std::move(options)), files_(std::move(files)), last_(options_.seconds()) {
  check_setting(options_.interval >= 0, "the interval of checkpoints (s)", options_.interval, "0 or more");
  check_setting(options_.time_interval > 0, "the time_interval of checkpoints (s)", options_.time_interval, "above 0");
  require(detail::fault_of_notes(options_.notes));
}
SCREE_BODY CheckpointPolicy::~CheckpointPolicy() = default;

SCREE_BODY Snapshot CheckpointPolicy::read(std::filesystem::path const& file,
                                           std::function<void(std::string const&)> const& report) const {
  auto snapshot = files_.read(file);
  if (report)
    for (auto const& change : changes_of_notes(snapshot.notes, options_.notes)) report(file.string() + ": " + change);
  return snapshot;
}
SCREE_BODY void CheckpointPolicy::keep(std::string const& name, std::function<std::vector<double>()> numbers) {
  std::vector<std::string> names = {name};
  for (auto const& kept : kept_)
    if (kept.first != name) names.push_back(kept.first);
  require(detail::fault_of_names(std::move(names), "numbers to keep"));
  kept_[name] = std::move(numbers);
}
SCREE_BODY bool CheckpointPolicy::due() const {
  return interrupt_.requested() || options_.seconds() - last_ >= options_.interval;
}
SCREE_BODY void CheckpointPolicy::save(Snapshot snapshot) {
  snapshot.notes = options_.notes;
  for (auto const& [name, numbers] : kept_) add_numbers(snapshot, name, numbers());
  if (writes_files()) files_.write(options_.file, snapshot);
  last_ = options_.seconds();  // the time after writing, so that a slow disk does not stop the run
  next_ = next_after(snapshot.time);
}
SCREE_BODY void CheckpointPolicy::require(std::string const& no_fault) {
  if (!no_fault.empty()) throw std::invalid_argument("scree: checkpoints: " + no_fault);
}
SCREE_BODY double CheckpointPolicy::next_after(double time) const {
  double const interval = options_.time_interval;
  return std::isinf(interval) ? interval : interval * std::floor(time / interval * (1 + 1e-12) + 1);
}
SCREE_BODY bool CheckpointPolicy::is_reached(double time) {
  if (!next_) next_ = next_after(time);
  return time * (1 + 1e-12) >= *next_;
}

}  // namespace scree
