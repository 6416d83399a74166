// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/preview.hpp>

#include "preview_page.hpp"

#include <scree/app/say.hpp>
#include <scree/core/writes_files.hpp>
#include <scree/io/write_file.hpp>

#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>

namespace scree::app {

namespace fs = std::filesystem;

namespace {

constexpr char const* mark = "<meta name=\"generator\" content=\"scree\">";  // in src/app/page/page.html

bool is_page(fs::path const& file) {
  std::string beginning(1000, ' ');
  std::ifstream(file, std::ios::binary).read(beginning.data(), std::streamsize(beginning.size()));
  return beginning.find(mark) != std::string::npos;
}

std::string date_now() {
  std::time_t const now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  ::localtime_r(&now, &local);
  char text[40];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local)};
}

std::string limit_of(StartState const& state) {
  for (auto const& [name, count] : state.limits)
    if (count > 0) return ", limited by: " + name;
  return "";
}

/// Rows with a name and its description.
ReportOfStart report_of(StartState const& state, StartParticles const& particles) {
  ReportOfStart report;
  report.emplace_back("checks of the start", state.refusal ? "refused: " + *state.refusal : "passed");
  if (!state.warning.empty()) report.emplace_back("warning", state.warning);
  for (auto const& body : particles.bodies) report.emplace_back(body.name, fmt::format("{} particles", body.count));
  report.emplace_back("spacing", fmt::format("{:.4g} m", state.spacing));
  auto const& axes = particles.axes;
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (particles.bodies.front().count > 0)
      report.emplace_back(fmt::format("{} of the {}", axes[a].name, particles.bodies.front().name),
                          fmt::format("{:.4g} to {:.4g} m", axes[a].low, axes[a].high));
  for (auto const& scalar : particles.scalars)
    if (scalar.name == "velocity" || scalar.low != 0 || scalar.high != 0)
      report.emplace_back(scalar.name, fmt::format("{:.4g} to {:.4g}{}", scalar.low, scalar.high,
                                                   scalar.unit == "1" ? "" : " " + scalar.unit));
  if (state.snapshot.time > 0) report.emplace_back("time", fmt::format("{:.6g} s", state.snapshot.time));
  if (state.step > 0) report.emplace_back("first step", fmt::format("{:.3g} s{}", state.step, limit_of(state)));
  return report;
}

}  // namespace

Preview::Preview(std::string program, CommandLine const& line)
    : title_(
          fmt::format("{}, {}", program, line.case_file.empty() ? "default case" : line.case_file.filename().string())),
      file_(line.output / "preview.html"),
      quiet_(line.quiet) {
  for (auto const& override_ : line.overrides) title_ += ", " + override_;
  title_ = printable(title_);
  std::error_code unknown;
  if (fs::exists(fs::symlink_status(file_, unknown)) && !(fs::is_regular_file(file_, unknown) && is_page(file_)))
    throw std::runtime_error(fmt::format("{}: is no preview; give another --output", file_.string()));
}

void Preview::write(StartState const& state) const {
  if (!writes_files()) return;
  StartParticles const particles(state.snapshot);
  auto const report = report_of(state, particles);
  std::error_code error;
  fs::create_directories(file_.parent_path(), error);
  if (error && !fs::is_directory(file_.parent_path()))
    throw std::runtime_error(
        fmt::format("{}: cannot create the output directory: {}", file_.parent_path().string(), error.message()));
  write_file(file_, page_of_start({.title = title_ + ", " + date_now(), .spacing = state.spacing}, particles, report));
  if (!quiet_)
    for (auto const& [name, text] : report) say(stdout, "{}: {}\n", name, printable(text));
  say(stdout, "preview of the start, for a browser: {}\n", file_.string());
}

}  // namespace scree::app
