// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// R9: a value that is not finite, in any field that a run depends on, for any particle and step.
#include "tally.hpp"

#include <support/granular_box.hpp>

#include <scree/integrators/symplectic_euler.hpp>

#include <catch2/catch_template_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::test::not_finite_tests {
using namespace fields;
namespace {

template <class Real>
struct TurningInTurn : granular_box::Turning<Real> {
  using integrator = SymplecticEuler;
};

/// The box of granular_box with the integrator of P.
template <class P>
Solver<P> turning() {
  auto const model = granular_box::turning<typename P::real>();
  SolverSettings<P> settings;
  settings.spacing = model.settings().spacing;
  settings.physics = model.settings().physics;
  settings.motion = model.settings().motion;
  Solver<P> solver(settings, model.material().to_host(position), model.wall().to_host(position));
  auto const copy = [&](auto field) {
    auto const values = model.material().to_host(field);
    std::size_t next = 0;
    solver.set(field, values, [&](auto const&) { return values[next++]; });
  };
  copy(concentration), copy(velocity), copy(stress);
  return solver;
}

template <class S, Field F>
void inject(S& solver, F field, int particle, int entry, double bad) {
  using real = typename S::policy::real;
  auto values = solver.material().to_host(field);
  auto& value = values[static_cast<std::size_t>(particle)];
  if constexpr (std::is_arithmetic_v<value_t<typename S::policy, F>>)
    value = real(bad);
  else
    value.data()[entry % value.size()] = real(bad);
  std::size_t next = 0;
  solver.set(field, values, [&](auto const&) { return values[next++]; });
}

/// Number of steps before an error, and its text.
template <class S>
std::pair<std::string, long> stopped(S& solver, long most) {
  long const before = solver.steps();
  try {
    while (solver.steps() < before + most) solver.step(1);
  } catch (std::runtime_error const& error) {
    return {error.what(), solver.steps() - before};
  }
  return {"", most};
}

/// The fault of a report on a value that became bad at a given point, or an empty string.
template <class S, class X>
std::string fault_of(std::string const& report, S const& solver, std::vector<X> const& places, int particle,
                     long steps) {
  std::string const start = "scree: particle ";
  if (!report.starts_with(start)) return report.empty() ? "nothing is reported" : "reported as: " + report;
  for (auto const* words : {" is not finite after step ", " at (", " m: ", " = "})
    if (report.find(words) == std::string::npos) return "no '" + std::string(words) + "' in: " + report;
  if (report.find(" is not finite after step " + std::to_string(solver.steps()) + " at (") == std::string::npos)
    return "another step than " + std::to_string(solver.steps()) + " in: " + report;
  // Such values spread by a support in each half of a step, and the message names the particle with the lowest number.
  auto const named = std::stoul(report.substr(start.size()));
  double const away = double((places.at(named) - places.at(std::size_t(particle))).norm());
  if (away > double(2 * steps + 2) * solver.resolution().support)
    return "particle " + std::to_string(particle) + ": " + report;
  return "";
}

template <class P, Field F>
void attempt(Tally& tally, Solver<P>& solver, std::vector<Snapshot> const& states, F field, std::mt19937& generator,
             long& latest) {
  double const infinity = std::numeric_limits<double>::infinity();
  double const values[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  auto const& state = states[std::size_t(random_below(generator, int(states.size())))];
  int const particle = random_below(generator, solver.material().size());
  double const bad = values[random_below(generator, 3)];
  solver.restore(state);  // which checks the first step; injected later
  granular_box::stepped(solver, solver.steps() + 1 + random_below(generator, 9));
  auto const places = solver.material().to_host(position);
  if constexpr (std::is_same_v<F, Volume>) {  // refused at once, and nothing is changed
    std::string refusal = "set";
    try {
      inject(solver, field, particle, 0, bad);
    } catch (std::invalid_argument const& error) {
      refusal = error.what();
    }
    std::string const expected = "scree: the volume (m^dim) of particle " + std::to_string(particle) +
                                 " of the material must be above 0 and finite, not ";
    auto const volumes = solver.material().to_host(volume);
    bool const kept = std::all_of(volumes.begin(), volumes.end(), [](auto V) { return V > 0 && std::isfinite(V); });
    tally.count(refusal.starts_with(expected) && kept ? "" : "volume = " + std::to_string(bad) + ": " + refusal);
    return;
  }
  inject(solver, field, particle, random_below(generator, 6), bad);
  auto const [report, steps] = stopped(solver, 300);
  latest = std::max(latest, steps);
  auto const fault = fault_of(report, solver, places, particle, steps);
  tally.count(fault.empty() ? ""
                            : std::string(F::name) + " = " + std::to_string(bad) + " at step " +
                                  std::to_string(state.steps) + ": " + fault);
}

template <class P, class... Fs>
void attempt_each(Tally& tally, Fields<Fs...>) {
  std::mt19937 generator(1);
  auto solver = turning<P>();
  std::vector<Snapshot> states;
  for (int k = 0; k < 8; ++k) {
    states.push_back(solver.snapshot());
    granular_box::stepped(solver, solver.steps() + 1 + random_below(generator, 9));
  }
  long latest = 0;
  for (int k = 0; k < attempts(2, 30); ++k) (attempt(tally, solver, states, Fs{}, generator, latest), ...);
  tally.note(std::to_string(sizeof...(Fs)) + " fields, found within " + std::to_string(latest) + " steps");
}

}  // namespace

TEMPLATE_TEST_CASE("a value that is not finite is reported, whatever field it is in", "[R9]",
                   granular_box::Turning<double>, granular_box::Turning<float>, TurningInTurn<double>) {
  using P = TestType;
  Tally tally("R9");
  attempt_each<P>(tally, Merge<typename Solver<P>::Evolved, Fields<Volume>>{});
}

TEST_CASE("a run that ends before the next look reports what is not finite", "[R9]") {
  using P = granular_box::Turning<double>;
  Tally tally("R9");
  tally.note("at the end of a run");
  auto solver = turning<P>();
  auto const looks_in = [&] { return solver.snapshot().counters.at("next look at step limits") - solver.steps(); };
  double dt = 0;
  while (solver.steps() < 1000 && looks_in() < 3) dt = solver.step(1);
  REQUIRE(looks_in() >= 3);
  for (int const particle : {3, 57, 159}) {
    while (looks_in() < 3) solver.step(1);
    auto const state = solver.snapshot();
    inject(solver, opening, particle, 0, std::numeric_limits<double>::quiet_NaN());
    std::string report;
    try {
      solver.run(solver.time() + dt);
    } catch (std::runtime_error const& error) {
      report = error.what();
    }
    tally.count(report.starts_with("scree: particle ") ? "" : "opening: nothing is reported at the end of a run");
    solver.restore(state);
    solver.step(dt);  // a restored run makes one extra check
  }
}

TEST_CASE("no snapshot is made of values that are not finite", "[R9]") {
  using P = granular_box::Turning<double>;
  Tally tally("R9");
  tally.note("as a snapshot");
  auto solver = turning<P>();
  granular_box::stepped(solver, 20);
  auto const state = solver.snapshot();
  for (int const particle : {3, 57, 159}) {
    solver.restore(state);
    inject(solver, stress, particle, 0, std::numeric_limits<double>::infinity());
    std::string report;
    try {
      solver.snapshot();
    } catch (std::runtime_error const& error) {
      report = error.what();
    }
    bool const named = report.starts_with("scree: particle " + std::to_string(particle) + " is not finite");
    tally.count(named ? "" : "stress: a snapshot is made of what no run can go on from");
  }
}

}  // namespace scree::test::not_finite_tests
