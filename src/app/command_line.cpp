// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/command_line.hpp>

#include <scree/app/say.hpp>
#include <scree/version.hpp>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <sstream>

namespace scree::app {

namespace {
/// For a program that is started without a word.
std::string usage(Program const& program) {
  return fmt::format(
      "{0}: {1}\n"
      "Nothing was run. Say which case, or where the results of the one with all defaults go:\n"
      "  {0} CASE.toml --output OUT\n"
      "  {0} --output {0}_output\n"
      "{0} --options prints all options with their defaults, {0} --help all arguments.\n",
      program.name, program.summary);
}
}  // namespace

std::optional<CommandLine> read_command_line(std::vector<std::string> arguments, Program const& program,
                                             int& exit_code) {
  std::erase_if(arguments, [](std::string const& argument) { return argument.starts_with("--kokkos-"); });
  std::ranges::reverse(arguments);  // as CLI11 wants them

  auto const named = [](std::string const& name) { return std::string(name.empty() ? "its name is empty" : ""); };
  CommandLine found{.output = program.name + "_output"};
  if (arguments.empty()) {
    say(stderr, "{}", usage(program));
    exit_code = 2;
    return std::nullopt;
  }
  CLI::App app(program.summary, program.name);
  app.set_version_flag("--version", fmt::format("{} of scree {}.{}.{}", program.name, library_version.major,
                                                library_version.minor, library_version.patch));
  app.footer("Arguments that begin with --kokkos- go to Kokkos (--kokkos-help lists them).");
  app.add_option("case", found.case_file, "case file (TOML); without it every option has its default")->check(named);
  app.add_option("--set", found.overrides, "section.key=value: an option over the case file's; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--output", found.output, "directory of the results")->check(named)->capture_default_str();
  app.add_flag("--force", found.force, "replace the results of an earlier run in that directory");
  app.add_flag("--options", found.options, "print the table of all options and stop");
  app.add_flag("--quiet", found.quiet, "no progress");
  auto* const preview = app.add_flag(
      "--preview", found.preview, "write preview.html, a page of the start state, and what its checks find, and stop");
  auto* const study =
      app.add_option("--study", found.study, "file (TOML) with lists of values of options: a run for each combination");
  study->check(named)->excludes(preview);
  auto* const vary =
      app.add_option("--vary", found.vary, "section.key=[value, ...]: the same for an option; may be repeated");
  vary->allow_extra_args(false)->excludes(preview);
  app.add_option("--workers", found.workers, "runs of a study at a time; 0: as many as keep the device busy")
      ->check(CLI::Range(0, 1024));
  if (program.profiles)
    app.add_flag("--profile", found.profile, "print at the end what the steps cost, on each rank of the case")
        ->excludes(study)
        ->excludes(vary);
  try {
    app.parse(arguments);
  } catch (CLI::ParseError const& error) {
    std::ostringstream help, faults;
    exit_code = app.exit(error, help, faults) == 0 ? 0 : 2;
    say(stdout, "{}", help.str());
    std::istringstream lines(faults.str());
    for (std::string line; std::getline(lines, line);) say(stderr, "{}\n", printable(line));
    return std::nullopt;
  }
  exit_code = 0;
  return found;
}

}  // namespace scree::app
