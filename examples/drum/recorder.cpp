// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"

#include "summary.hpp"
#include "tables.hpp"
#include "window.hpp"

#include <scree/app/output_directory.hpp>
#include <scree/app/say.hpp>

#include <scree/io/csv_series.hpp>
#include <scree/io/vtkhdf.hpp>
#include <scree/run/progress.hpp>
#include <scree/solver/outside_validity.hpp>

namespace drum {

namespace {

void require_finite(State const& state, std::filesystem::path const& output) {
  double sum = 0;
  for (auto const* values : {&state.x, &state.z, &state.u, &state.w, &state.C, &state.stress})
    for (double value : *values) sum += std::abs(value);
  if (!std::isfinite(sum))
    throw std::runtime_error(
        fmt::format("places, velocities, stresses or C are no longer finite at {:.3f} s; what was written before is "
                    "kept in {}",
                    state.time, output.string()));
}
/// The model takes the density of the bed for constant; a bed that volume control does not hold together swells to 0.8.
double least_density(Options const& o) { return o.numerics.volume_control == VolumeControl::none ? 0.6 : 0.8; }

/// Throws scree::OutsideValidity where what moves is no bed in a drum.
void require_bed(Moment const& m, std::size_t particles, Options const& o) {
  auto const stop = [&](std::string const& what) {
    throw scree::OutsideValidity(fmt::format("outside the validity of the model at {:.4g} s: {}", m.time, what));
  };
  if (m.lost > 1e-3 * double(particles))
    stop(fmt::format("{} of {} particles are outside of the drum, at most 0.1 % may be", m.lost, particles));
  if (m.number_density < least_density(o))
    stop(fmt::format("the mean number density of the interior is {:.3f}, at least {} is needed: the bed has blown up",
                     m.number_density, least_density(o)));
}

/// The directory of the files that a run goes on with; empty: none.
std::filesystem::path directory_before(Options const& options) {
  return std::filesystem::path(options.time.restart_from).parent_path();
}
bool continues(Options const& options) { return !options.time.restart_from.empty(); }
std::filesystem::path frames_before(Options const& options) { return directory_before(options) / "particles.vtkhdf"; }
bool has_frames_before(Options const& options) {
  return continues(options) && std::filesystem::exists(frames_before(options));
}

/// Results stay as they were until here.
Past begin(scree::app::Run<Options> const& run, Start const& start) {
  if (start.time > run.options.time.duration)
    throw std::runtime_error(fmt::format("time.duration: {} s is over at the start from {}, at {} s",
                                         run.options.time.duration, run.options.time.restart_from, start.time));
  Past past;
  if (continues(run.options)) past = read_past(directory_before(run.options), start.time);
  if (has_frames_before(run.options)) scree::VtkHdfSeries::check(frames_before(run.options));
  scree::app::begin_results(run);
  return past;
}

using Rows = scree::CsvSeries::Rows;
Rows history_rows(Past const& past) {
  Rows rows;
  for (auto const& m : past.moments) rows.push_back(row_of(m));
  return rows;
}
Rows profile_rows(Past const& past) {
  Rows rows;
  for (auto const& profile : past.profiles)
    for (auto const& at : profile.rows) rows.push_back(row_of(profile, at));
  return rows;
}

scree::VtkHdfSeries frames_of(scree::app::Run<Options> const& run, double start_time) {
  auto const file = run.output / "particles.vtkhdf";
  scree::VtkHdfOptions const options{.single_precision = true, .provenance = {{"case", run.case_text}}};
  if (!has_frames_before(run.options)) return scree::VtkHdfSeries(file, options);
  return scree::VtkHdfSeries::continued(frames_before(run.options), start_time, file, options);
}
}  // namespace

struct Recorder::Files {
  Files(scree::app::Run<Options> const& r, Start const& s)
      : run(r),
        drum(drum_of(run.options)),
        window(unpack(s.memory)),
        past(begin(run, s)),
        history(run.output / "history.csv", history_names(), history_rows(past)),
        profiles(run.output / "profiles.csv", profile_names(), profile_rows(past)),
        radial(run.output / "radial.csv", radial_names(), past.rings),
        frames(frames_of(run, s.time)),
        progress({.end = run.options.time.duration, .name = "t/s", .quiet = run.quiet}) {
    if (!moments().empty()) seconds_before = moments().back().wall_seconds;
    auto const& times = run.options.output.profile_times;
    double const done = moments().empty() ? 0 : moments().back().time + profile_rounding;
    next_profile = std::ranges::upper_bound(times, done) - times.begin();  // there is no flow yet at 0
  }

  std::vector<Moment>& moments() { return past.moments; }
  void write(Profile const& profile, std::vector<Ring> const& rings);
  void write_due_profiles(double time);

  scree::app::Run<Options> run;
  Drum drum;
  Window window;  // the last output.profile_average seconds
  Past past;      // grows with the run
  scree::CsvSeries history, profiles, radial;
  scree::VtkHdfSeries frames;
  scree::Progress progress;
  std::ptrdiff_t next_profile = 0;
  double start = scree::wall_seconds(), seconds_before = 0;
};

Recorder::Recorder(scree::app::Run<Options> const& run, Start const& start)
    : files_(std::make_unique<Files>(run, start)) {}
Recorder::~Recorder() = default;

std::vector<double> Recorder::memory() const { return pack(files_->window); }

void Recorder::Files::write(Profile const& profile, std::vector<Ring> const& rings) {
  for (auto const& at : profile.rows) profiles.row(row_of(profile, at));
  for (auto const& ring : rings)
    radial.row({profile.time, ring.radius, ring.radius / drum.radius, ring.particles, ring.C, ring.number_density});
  past.profiles.push_back(profile);
}

void Recorder::Files::write_due_profiles(double time) {
  auto const& times = run.options.output.profile_times;
  for (; next_profile < std::ssize(times); ++next_profile) {
    double const due = times[static_cast<std::size_t>(next_profile)];
    if (due > time + profile_rounding) return;
    Sample mean;
    for (auto const& sample : window) mean.chord.add(sample.chord), mean.rings.add(sample.rings);
    write(mean.chord.mean(due, drum), mean.rings.mean());
  }
}

void Recorder::record_history(State const& given) {
  Files& f = *files_;
  require_finite(given, f.run.output);
  auto const state = seen_clockwise(given, f.drum);
  auto const surface = fit_surface(state, f.drum);
  Sample now{.time = state.time, .chord = {}, .rings = {}};
  now.chord.add(state, surface, f.drum);
  now.rings.add(state, f.drum);

  auto m = moment(state, surface, now.chord.mean(state.time, f.drum), f.drum);
  m.wall_seconds = f.seconds_before + scree::wall_seconds() - f.start;
  f.history.row(row_of(m));
  f.moments().push_back(m);
  require_bed(m, state.size(), f.run.options);

  double const begin = state.time - f.run.options.output.profile_average + 1e-9;
  f.window.push_back(std::move(now));
  while (f.window.size() > 1 && f.window.front().time < begin) f.window.pop_front();
  f.write_due_profiles(state.time);
  f.progress.update(state.time, state.steps);
}

void Recorder::record_frame(scree::PointData const& frame) { files_->frames.append(frame); }

void Recorder::finish(RunFigures const& figures) {
  Files& f = *files_;
  f.progress.finish(figures.time, figures.steps);
  if (!f.moments().empty()) f.moments().back().wall_seconds = f.seconds_before + scree::wall_seconds() - f.start;
  Results const results{f.run.options, figures, f.moments(), f.past.profiles};
  scree::write_file(f.run.output / "summary.json", scree::app::to_json(summary(results)));
  if (f.run.quiet || f.moments().empty()) return;
  Moment const& last = f.moments().back();
  scree::app::say(
      stdout,
      "at {:.2f} s: surface at {:.1f} degrees, {:.2f} cm/s at mid-chord, bed {:.2f} mm deep, active layer {:.2f} "
      "of it\ninterior number density {:.3f}, least {:.3f}; lost {:.0f}; C between {:.3g} and {:.3g}\n"
      "results in {}\n",
      last.time, last.angle, 100 * last.surface_speed, 1000 * last.bed_depth, last.active_depth / last.bed_depth,
      last.number_density, last.number_density_min, last.lost, last.C_min, last.C_max, f.run.output.string());
}

}  // namespace drum
