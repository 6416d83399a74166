// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/start.hpp>

#include <scree/app/describe.hpp>
#include <scree/app/say.hpp>
#include <scree/solver/outside_validity.hpp>

#include <exception>

namespace scree::app {

namespace detail {

std::optional<AnyRun> start(std::vector<std::string> arguments, AnyCase const& into, Program const& program,
                            int& exit_code, std::function<std::filesystem::path()> const& checkpoint) {
  auto const line = read_command_line(std::move(arguments), program, exit_code);
  if (!line) return std::nullopt;
  if (line->options) {
    say(stdout, "{}", option_table(into.list, into.standard));
    return std::nullopt;
  }
  for (auto const& note : read_case({into.list, into.options, into.standard}, line->case_file, line->overrides))
    print_note(note);
  OutputRequest request{
      .directory = line->output, .results = program.results, .force = line->force, .continues = checkpoint()};
  return AnyRun{.output = line->output,
                .quiet = line->quiet,
                .case_text = case_text(into.list, into.options),
                .directory = std::make_shared<OutputDirectory const>(std::move(request))};
}

}  // namespace detail

int guarded_main(std::function<int()> const& body) {
  try {
    return body();
  } catch (CaseError const& error) {
    say(stderr, "{}\n", error.what());
    return refused;
  } catch (OutsideValidity const& error) {
    say(stderr, "error: {}; results until then are kept\n", printable(error.what()));
    return outside_validity;
  } catch (std::filesystem::filesystem_error const& error) {
    say(stderr, "error: {}: {}\n", printable(error.path1().string()), error.code().message());
    return failed;
  } catch (std::exception const& error) {
    say(stderr, "error: {}\n", printable(error.what()));
    return failed;
  }
}

}  // namespace scree::app
