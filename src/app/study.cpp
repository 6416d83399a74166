// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/study.hpp>

#include "directory_lock.hpp"
#include "restart_option.hpp"
#include "study_table.hpp"

#include <scree/app/case_file.hpp>
#include <scree/app/describe.hpp>
#include <scree/app/say.hpp>
#include <scree/app/study_plan.hpp>
#include <scree/app/toml.hpp>
#include <scree/run/wall_clock.hpp>

#include <hdf5.h>

#include <algorithm>
#include <mutex>
#include <sstream>

namespace scree::app::detail {

namespace fs = std::filesystem;

namespace {

constexpr char const* end_file = "finished.txt";

fs::path made(fs::path const& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw std::runtime_error(
        fmt::format("{}: cannot create the output directory: {}", directory.string(), error.message()));
  return directory;
}
std::string content_of(fs::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}
bool is_there(fs::path const& file) {
  std::error_code unknown;
  return fs::exists(file, unknown);
}
/// The first line of a text that another has not, and that one's.
std::string difference(std::string const& there, std::string const& here) {
  std::istringstream a(there), b(here);
  for (std::string x, y; std::getline(a, x) && std::getline(b, y);)
    if (x != y) return fmt::format("'{}' there, '{}' here", x, y);
  return "one is longer";
}
bool has_threads() {
  hbool_t safe = false;
  return H5is_library_threadsafe(&safe) >= 0 && safe;
}

}  // namespace

struct Study::State {
  CommandLine line;
  OptionList const& list;
  void const* standard;
  Program program;
  RestartOption restart;
  StudyPlan plan;
  DirectoryLock lock;
  StudyTable table;
  std::vector<std::string> problems = {}, notes = {};
  std::mutex one_at_a_time = {};

  State(CommandLine const& l, OptionList const& options, void const* s, Program const& p)
      : line(l),
        list(options),
        standard(s),
        program(p),
        restart(options, p.restart, s),
        plan(read_study(line.study, line.vary)),
        lock(made(line.output)),
        table(line.output / "study.csv", plan.members(), columns()) {}

  std::vector<std::string> columns() const {
    std::vector<std::string> names;
    for (auto const& each : plan.varied) {
      auto const* option = list.find(each.section, each.name);
      bool const has_unit = option != nullptr && !option->about.unit.empty() && option->about.unit != "1";
      names.push_back(each.key() + (has_unit ? " [" + option->about.unit + "]" : ""));
    }
    return names;
  }
  fs::path directory_of(std::size_t member) const { return line.output / table.name_of(member); }
  /// The checkpoint to continue a member from; empty: none.
  fs::path checkpoint_in(fs::path const& directory) const {
    if (line.force || !restart) return {};
    for (auto const* name : {"checkpoint.h5", "checkpoint.previous.h5"})
      if (is_there(directory / name)) return directory / name;
    return {};
  }
  void refuse(std::string const& problem) {
    if (std::ranges::find(problems, problem) == problems.end()) problems.push_back(problem);
  }
  /// The case file that is in a directory as text, with the checkpoint to start from that these options have.
  std::string case_before(fs::path const& directory, void const* options, void* scratch) const {
    read_case({list, scratch, standard}, directory / "case.toml", {});
    restart.copy(options, scratch);
    return case_text(list, scratch);
  }
};

Study::Study(CommandLine const& line, OptionList const& list, void const* standard, Program const& program)
    : state_(std::make_unique<State>(line, list, standard, program)) {}
Study::~Study() = default;

std::size_t Study::size() const { return state_->plan.members(); }

void Study::read(std::size_t member, void* options) {
  auto const& line = state_->line;
  try {
    auto const sections = state_->plan.sections_of(member);
    for (auto const& note :
         read_case({state_->list, options, state_->standard}, line.case_file, line.overrides, sections))
      if (std::ranges::find(state_->notes, note) == state_->notes.end()) {
        state_->notes.push_back(note);
        print_note(note);
      }
    std::vector<std::string> values;
    for (auto const& each : state_->plan.varied)
      values.push_back(state_->list.find(each.section, each.name)->text(options));
    state_->table.set_values(member, values);
  } catch (CaseError const& error) {
    for (auto const& problem : error.lines) state_->refuse(problem);
  }
}

void Study::look(std::size_t member, void const* options, void* scratch) {
  auto const directory = state_->directory_of(member);
  auto const file = directory / "case.toml";
  if (state_->line.force || !is_there(file)) return;
  try {
    auto const before = state_->case_before(directory, options, scratch), now = case_text(state_->list, options);
    if (before != now)
      state_->refuse(fmt::format("{}: is of another case ({}); give another --output, or --force to replace it",
                                 file.string(), printable(difference(before, now))));
  } catch (CaseError const& error) {
    for (auto const& problem : error.lines) state_->refuse(problem);
  }
  if (is_there(directory / end_file)) state_->table.set_end(member, content_of(directory / end_file), directory);
}

void Study::check() const {
  if (!state_->problems.empty()) throw CaseError(state_->problems);
}

bool Study::finished(std::size_t member) const { return state_->table.finished(member); }

AnyRun Study::begin(std::size_t member, void* options) {
  auto const directory = state_->directory_of(member);
  auto const own = state_->checkpoint_in(directory);
  bool const begun = is_there(directory / "case.toml");  // look() has seen that it is of this case
  if (!own.empty()) state_->restart.set(options, own);
  OutputRequest request{.directory = directory,
                        .results = state_->program.results,
                        .force = state_->line.force || begun,
                        .continues = state_->restart.of(options)};
  return {.output = directory,
          .quiet = true,
          .case_text = case_text(state_->list, options),
          .directory = take_directory(std::move(request))};
}

void Study::run(std::size_t member, std::function<int()> const& body) {
  double const began = wall_seconds();
  auto const outcome = outcome_of(body);
  bool const done = outcome.exit_code == 0 || outcome.exit_code == outside_validity;
  auto const directory = state_->directory_of(member);
  auto const end = fmt::format("{}\n{}\n", outcome.exit_code, outcome.message);
  std::scoped_lock const lock(state_->one_at_a_time);
  state_->table.set_end(member, end, directory);
  if (!outcome.message.empty()) say(stderr, "{}: {}\n", directory.string(), outcome.message);
  if (!state_->line.quiet)
    say(stderr, "{} of {} done, {} {} after {}: {}\n", state_->table.done(), size(), state_->table.name_of(member),
        state_->table.state_of(member), clock_text(wall_seconds() - began), state_->table.values_of(member));
  if (done) write_file(directory / end_file, end);
  state_->table.write();
}

int Study::workers(bool one_at_a_time) const {
  int const asked = state_->line.workers;
  if (one_at_a_time && asked > 1)
    throw CaseError({fmt::format("--workers: {} runs one case at a time", state_->program.name)});
  if (!one_at_a_time && asked != 1 && !has_threads()) {
    print_note("this HDF5 is not built for threads: the members of the study run one after the other");
    return 1;
  }
  return one_at_a_time ? 1 : asked;
}

int Study::finish(int signal_code) const {
  auto const& table = state_->table;
  table.write();
  if (!state_->line.quiet) say(stdout, "{}\nresults in {}\n", table.counts(), table.file().string());
  return signal_code != 0 ? signal_code : table.exit_code();
}

}  // namespace scree::app::detail
