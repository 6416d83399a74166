// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/checkpoints.hpp>

#include <scree/app/say.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/io/vtkhdf.hpp>

namespace scree::app {

About about_restart() { return {.meaning = "checkpoint to continue from; empty: none"}; }
About about_checkpoints() {
  return {.unit = "s", .range = {0, 1e9}, .meaning = "wall time between checkpoints; a signal leaves one, too"};
}

CheckpointOptions Checkpoints::options_of(std::filesystem::path const& output, std::string const& case_text,
                                          double interval) {
  return {.file = output / "checkpoint.h5", .interval = interval, .notes = {{"case", case_text}}};
}
Checkpoints::Checkpoints(CheckpointOptions options, std::filesystem::path from)
    : CheckpointPolicy(options, {write_checkpoint, read_checkpoint}),
      output_(options.file.parent_path()),
      from_(std::move(from)),
      notes_(std::move(options.notes)) {}

Checkpoints::~Checkpoints() = default;

void Checkpoints::keep(std::string const& name, std::function<Numbers()> numbers,
                       std::function<void(Numbers const&)> take) {
  if (restored_) throw std::logic_error("scree: keep(\"" + name + "\") comes after restore(): call it before");
  keep(name, std::move(numbers));
  take_[name] = std::move(take);
}

// The checkpoint that a run starts from is no change of its case.
void Checkpoints::print(std::string const& note) {
  if (note.find(" restart_from = ") == std::string::npos) print_note(note);
}

void Checkpoints::take(Snapshot const& snapshot, double end, std::vector<Table> const& tables,
                       std::string const& frames) {
  auto const refuse = [&](std::string const& what) { throw std::runtime_error(from_.string() + ": " + what); };
  time_ = snapshot.time;
  if (time_ > end * (1 + 1e-12))
    refuse(fmt::format("it is from {:.6g} s, and the run ends at {:.6g} s: make the run longer", time_, end));
  for (auto const& [name, take] : take_) {
    if (snapshot.find(name) == nullptr)
      refuse("it holds no '" + name + "': another program, or an older one, wrote it");
    take(numbers_in(snapshot, name));
  }
  for (auto const& table : tables) CsvSeries::check(before() / table.file, table.columns);
  if (!frames.empty()) VtkHdfSeries::check(before() / frames);
}

CsvSeries Checkpoints::open(Table const& table) const {
  auto const file = output_ / table.file;
  if (!restarts()) return {file, table.columns};
  return CsvSeries::continued(before() / table.file, time_ / table.unit, file, table.columns);
}

}  // namespace scree::app
