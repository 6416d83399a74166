// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/start.hpp>

#include "restart_option.hpp"

#include <scree/app/describe.hpp>
#include <scree/app/say.hpp>
#include <scree/io/checkpoint.hpp>
#include <scree/passes/outside_validity.hpp>

#include <exception>

namespace scree::app {

namespace detail {

void refuse_empty(double spacing) {
  throw CaseError(
      {fmt::format("the material has no particles: what it fills is thinner than the spacing, {:.6g} m, and "
                   "no inlet brings any; make the spacing smaller or the filling larger",
                   spacing)});
}

std::shared_ptr<OutputDirectory const> take_directory(OutputRequest request) {
  if (!request.continues.empty()) read_checkpoint(request.continues);
  return std::make_shared<OutputDirectory const>(std::move(request));
}

std::optional<AnyRun> start(CommandLine const& line, AnyCase const& into, Program const& program) {
  if (line.is_study() && !line.options) throw CaseError({"--study, --vary: this program runs one case"});
  if (line.workers != 0) print_note("--workers has no effect without --study or --vary");
  if (line.options) {
    say(stdout, "{}", option_table(into.list, into.standard));
    return std::nullopt;
  }
  for (auto const& note : read_case({into.list, into.options, into.standard}, line.case_file, line.overrides))
    print_note(note);
  RestartOption const restart(into.list, program.restart, into.standard);
  if (line.preview)
    return AnyRun{.output = line.output,
                  .quiet = line.quiet,
                  .case_text = case_text(into.list, into.options),
                  .directory = nullptr,
                  .preview = std::make_shared<Preview const>(program.name, line)};
  OutputRequest request{
      .directory = line.output, .results = program.results, .force = line.force, .continues = restart.of(into.options)};
  return AnyRun{.output = line.output,
                .quiet = line.quiet,
                .profile = line.profile,
                .case_text = case_text(into.list, into.options),
                .directory = writes_files() ? take_directory(std::move(request)) : nullptr};
}

bool has_restart(OptionList const& list, Program const& program) {
  return bool(RestartOption(list, program.restart, nullptr));
}

void note_how_to_continue(int signal, CommandLine const& line, OptionList const& list, Program const& program) {
  RestartOption const restart(list, program.restart, nullptr);
  if (!restart) return;
  auto const checkpoint = line.output / "checkpoint.h5";
  std::error_code unknown;
  if (!std::filesystem::exists(checkpoint, unknown)) return;
  print_note(fmt::format("stopped by signal {}; to continue, add --set '{}=\"{}\"' to the command", signal,
                         restart.key(), checkpoint.string()));
}

}  // namespace detail

Outcome outcome_of(std::function<int()> const& body) {
  auto const error = [](std::string const& what) { return "error: " + what; };
  try {
    return {body()};
  } catch (PreviewWritten const&) {
    return {0};
  } catch (CaseError const& wrong) {
    return {refused, wrong.what()};
  } catch (OutsideValidity const& end) {
    return {outside_validity, error(printable(end.what()) + "; results until then are kept")};
  } catch (std::filesystem::filesystem_error const& wrong) {
    return {failed, error(printable(wrong.path1().string()) + ": " + wrong.code().message())};
  } catch (std::exception const& wrong) {
    return {failed, error(printable(wrong.what()))};
  }
}

void print_message(Outcome const& outcome) {
  if (!outcome.message.empty()) say(stderr, "{}\n", outcome.message);
}

int guarded_main(std::function<int()> const& body) {
  auto const outcome = outcome_of(body);
  print_message(outcome);
  return outcome.exit_code;
}

}  // namespace scree::app
