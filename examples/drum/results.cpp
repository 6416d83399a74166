// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "results.hpp"

#include "summary.hpp"
#include "tables.hpp"

#include <scree/app/say.hpp>
#include <scree/io/vtkhdf.hpp>
#include <scree/passes/outside_validity.hpp>
#include <scree/run/wall_clock.hpp>

#include <optional>

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

/// The directory of the files that a run continues; empty: none.
std::filesystem::path directory_before(Options const& options) {
  return std::filesystem::path(options.output.restart_from).parent_path();
}
bool continues(Options const& options) { return !options.output.restart_from.empty(); }
std::filesystem::path frames_before(Options const& options) { return directory_before(options) / "particles.vtkhdf"; }
bool has_frames_before(Options const& options) {
  return continues(options) && std::filesystem::exists(frames_before(options));
}

/// Results stay as they were until here.
Past past_before(app::Run<Options> const& run, Start const& start, std::function<void()> const& begin) {
  if (start.time > run.options.time.duration)
    throw std::runtime_error(fmt::format("time.duration: {} s is over at the start from {}, at {} s",
                                         run.options.time.duration, run.options.output.restart_from, start.time));
  Past past;
  if (continues(run.options)) past = read_past(directory_before(run.options), start.time, run.options.species.count());
  if (has_frames_before(run.options)) scree::VtkHdfSeries::check(frames_before(run.options));
  if (begin) begin();
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

scree::VtkHdfSeries frames_of(app::Run<Options> const& run, double start_time) {
  auto const file = run.output / "particles.vtkhdf";
  scree::VtkHdfOptions const options{.single_precision = true, .provenance = {{"case", run.case_text}}};
  if (!has_frames_before(run.options)) return scree::VtkHdfSeries(file, options);
  return scree::VtkHdfSeries::continued(frames_before(run.options), start_time, file, options);
}
}  // namespace

struct Results::Files {
  Files(app::Run<Options> const& run, Start const& start, std::function<void()> const& begin);
  void write(Profile const& profile, std::vector<Ring> const& rings);
  void write_due_profiles(double time);
  void add_history(State const& given);
  void finish(app::Figures const& figures);

  app::Run<Options> run_;
  Drum drum_;
  Window window_;  // the last output.profile_average seconds
  Past past_;      // grows with the run
  scree::CsvSeries history_, profiles_, radial_;
  std::optional<scree::CsvSeries> species_;  // with a list of sizes
  scree::VtkHdfSeries frames_;
  std::ptrdiff_t next_profile_ = 0;
  double start_ = scree::wall_seconds(), seconds_before_ = 0;
};

Results::Results(app::Run<Options> const& run, Start const& start, std::function<void()> const& begin)
    : files_(std::make_unique<Files>(run, start, begin)) {}
Results::~Results() = default;
std::vector<double> Results::memory() const { return pack(files_->window_); }
void Results::add_history(State const& state) { files_->add_history(state); }
void Results::add_frame(scree::PointData const& frame) { files_->frames_.append(frame); }
void Results::finish(app::Figures const& figures) { files_->finish(figures); }

Results::Files::Files(app::Run<Options> const& run, Start const& start, std::function<void()> const& begin)
    : run_(run),
      drum_(drum_of(run.options)),
      window_(unpack(start.memory, run.options.species.count())),
      past_(past_before(run, start, begin)),
      history_(run.output / "history.csv", history_names(run.options.numerics.dimension), history_rows(past_)),
      profiles_(run.output / "profiles.csv", profile_names(drum_.species), profile_rows(past_)),
      radial_(run.output / "radial.csv", radial_names(drum_.species), past_.rings),
      frames_(frames_of(run, start.time)) {
  if (drum_.species > 0) species_.emplace(run.output / "species.csv", species_names(drum_.species), past_.species);
  auto const& moments = past_.moments;
  if (!moments.empty()) seconds_before_ = moments.back().wall_seconds;
  auto const& times = run.options.output.profile_times;
  double const done = moments.empty() ? 0 : moments.back().time + profile_rounding;
  next_profile_ = std::ranges::upper_bound(times, done) - times.begin();  // there is no flow yet at 0
}

void Results::Files::write(Profile const& profile, std::vector<Ring> const& rings) {
  for (auto const& at : profile.rows) profiles_.row(row_of(profile, at));
  for (auto const& ring : rings) {
    std::vector<double> row = {profile.time,   ring.radius, ring.radius / drum_.radius,
                               ring.particles, ring.C,      ring.number_density};
    row.insert(row.end(), ring.species.begin(), ring.species.end());
    radial_.row(row);
  }
  past_.profiles.push_back(profile);
}

void Results::Files::write_due_profiles(double time) {
  auto const& times = run_.options.output.profile_times;
  for (; next_profile_ < std::ssize(times); ++next_profile_) {
    double const due = times[static_cast<std::size_t>(next_profile_)];
    if (due > time + profile_rounding) return;
    auto mean = Sample::of(drum_.species);
    for (auto const& sample : window_) mean.chord.add(sample.chord), mean.rings.add(sample.rings);
    write(mean.chord.mean(due, drum_), mean.rings.mean());
  }
}

void Results::Files::add_history(State const& given) {
  require_finite(given, run_.output);
  auto const state = seen_clockwise(given, drum_);
  auto const surface = fit_surface(state, drum_);
  auto now = Sample::of(drum_.species);
  now.time = state.time;
  now.chord.add(state, surface, drum_);
  now.rings.add(state, drum_);

  auto const chord = now.chord.mean(state.time, drum_);
  auto m = moment(state, surface, chord, drum_);
  m.wall_seconds = seconds_before_ + scree::wall_seconds() - start_;
  history_.row(row_of(m));
  if (species_) species_->row(species_row(state, surface, chord, drum_));
  past_.moments.push_back(m);
  require_bed(m, state.size(), run_.options);

  double const begin = state.time - run_.options.output.profile_average + 1e-9;
  window_.push_back(std::move(now));
  while (window_.size() > 1 && window_.front().time < begin) window_.pop_front();
  write_due_profiles(state.time);
}

void Results::Files::finish(app::Figures const& figures) {
  if (!past_.moments.empty()) past_.moments.back().wall_seconds = seconds_before_ + scree::wall_seconds() - start_;
  Findings const found{run_.options, figures, past_.moments, past_.profiles};
  scree::write_file(run_.output / "summary.json", app::to_json(summary(found)));
  if (run_.quiet || past_.moments.empty()) return;
  Moment const& last = past_.moments.back();
  app::say(stdout,
           "at {:.2f} s: surface at {:.1f} degrees, {:.2f} cm/s at mid-chord, bed {:.2f} mm deep, active layer {:.2f} "
           "of it\ninterior number density {:.3f}, least {:.3f}; lost {:.0f}; C between {:.3g} and {:.3g}\n"
           "intensity of segregation {:.3g}, Lacey index {:.4f}\n"
           "results in {}\n",
           last.time, last.angle, 100 * last.surface_speed, 1000 * last.bed_depth, last.active_depth / last.bed_depth,
           last.number_density, last.number_density_min, last.lost, last.C_min, last.C_max, last.intensity, last.lacey,
           run_.output.string());
}

}  // namespace drum
