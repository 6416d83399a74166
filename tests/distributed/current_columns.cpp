// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::told_tests {
using namespace fields;

struct Seen : Scalar<"seen", "1"> {};
inline constexpr Seen seen{};
struct SeenLater : Scalar<"seen later", "1"> {};
inline constexpr SeenLater seen_later{};

template <class F>
struct Sum {
  using reads = Fields<Volume, Concentration>;
  using adds = Fields<F>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[F{}] += j[volume] * j[concentration] * ij.W();
  }
};
struct Grow {
  using reads = Fields<Concentration>;
  using writes = Fields<Concentration>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[concentration] = i[concentration] * decltype(i[concentration])(1.25);
  }
};
struct RateOfSum {
  using reads = Fields<>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[concentration_rate] = -total[seen_later];
  }
};
struct AtLeft {
  using reads = Fields<Position>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[position][0] < 0.05;
  }
};
auto const sum_seen = pair_pass<Material>("seen", over<Material>(Sum<Seen>{}));
auto const sum_later = pair_pass<Material>("seen later", over<Material>(Sum<SeenLater>{}));

/// A pass with a loop of its own, which names the fields that it uses and does not say which it changes.
struct GrowInOwnWay {
  template <class Body>
  using fields = std::conditional_t<std::is_same_v<Body, Material>, Fields<Concentration>, Fields<>>;
  template <class Sys>
  void run(Sys& system) const {
    auto const grow = [&] {
      for_each_particle<typename Sys::policy>("grow", system.template body<Material>(), Grow{});
    };
    grow();
    sum_seen.run(system);
    grow();
    sum_seen.run(system);
    grow();
  }
};
/// Neighbours read the concentration before and after each way to change it.
struct Growing {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(sum_seen, point_pass<Material>("grow", Grow{}), sum_later, GrowInOwnWay{},
                      pair_pass_then<Material>("rate", RateOfSum{}, over<Material>(Sum<SeenLater>{})));
  }
  auto projections(Resolution const&) const { return std::tuple(sum_seen); }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
struct Growth : Formulation<2> {
  using physics = Growing;
};

namespace {

auto const points = fill_lattice(Box<2>{{0, 0}, {0.2, 0.2}}, 0.01);

template <class F>
Solver<F> growth(Space const& space, SolverSettings<F> settings) {
  settings.spacing = 0.01;
  Solver<F> solver(space, settings, points);
  solver.set(concentration, [](auto const& x) { return 0.1 + x[0] + 2 * x[1]; });
  return solver;
}
/// Evaluates and changes fields in all ways that come to mind.
template <class S>
std::uint64_t end_of(S& solver) {
  solver.update_rates();
  solver.update_rates();
  for (int k = 0; k < 3; ++k) solver.step(0.01);
  auto const before = solver.snapshot();
  solver.set(concentration, [](auto const& x) { return 0.3 + x[1] * x[0]; });
  solver.update_rates();
  solver.set(volume, [](auto const& x) { return 1e-4 * (1 + x[0]); });
  solver.update_rates();
  solver.step(0.01);
  auto const after = state_hash(solver);
  solver.restore(before);
  solver.step(0.01);
  solver.remove(AtLeft{});
  solver.step(0.01);
  return after ^ state_hash(solver);
}

}  // namespace

TEST_CASE("passes that change fields between sums have the same bits on any number of ranks") {
  auto whole = growth<Whole<Growth>>(Space(), {});
  auto const expected = end_of(whole);
  for (int ranks : {1, 2, 3}) {
    std::uint64_t found = 0;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Growth>> settings;
      settings.ranks.team = team;
      auto solver = growth(space, settings);
      auto const here = end_of(solver);
      if (team.rank() == 0) found = here;
    });
    INFO(ranks << " ranks");
    CHECK(found == expected);
  }
}

TEST_CASE("a list of passes sends fields again only after passes that may have changed them") {
  std::vector<std::int64_t> messages, bytes, sent;
  run_on_threads<Space>(2, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Growth>> settings;
    settings.ranks.team = team;
    auto solver = growth(space, settings);
    solver.update_rates();  // makes the lists
    Traffic const before = team.traffic();
    solver.update_rates();
    auto const ghosts = team.gather(solver.material().ghosts());
    auto const found = team.gather(team.traffic().bytes - before.bytes);
    auto const number = team.gather(team.traffic().messages - before.messages);
    if (team.rank() == 0) messages = number, bytes = found, sent = {ghosts[1], ghosts[0]};
  });
  for (std::size_t rank : {0, 1}) {
    CHECK(sent[rank] > 10);
    CHECK(messages[rank] == 5);
    // Volume and concentration; the concentration; both twice in a pass that does not say what it changes, and after
    // it.
    CHECK(bytes[rank] == sent[rank] * std::int64_t(sizeof(double)) * (2 + 1 + 2 * 2 + 2));
  }
}

TEST_CASE("passes outside of lists get all fields each time") {
  std::vector<std::int64_t> bytes, sent;
  run_on_threads<Space>(2, [&](Team<Space> const& team, Space const& space) {
    using P = basis_of<OnRanks<Growth>>;
    DividedCase<Space> divided;
    divided.team = team;
    system_of<OnRanks<Growth>> system(space, 0.0144, {divided, std::vector<Period>()});
    auto& body = system.body<Material>();
    body.resize(int(points.size()));
    body.from_host(position, points);
    body.fill(volume, 1e-4);
    body.fill(concentration, 0.5);
    system.positions_changed();
    run_passes(system, std::tuple(sum_seen));
    Traffic const before = team.traffic();
    for (int k = 0; k < 3; ++k) {
      for_each_particle<P>("grow", body, Grow{});
      sum_seen.run(system);
    }
    auto const ghosts = team.gather(body.ghosts());
    auto const found = team.gather(team.traffic().bytes - before.bytes);
    if (team.rank() == 0) bytes = found, sent = {ghosts[1], ghosts[0]};
  });
  for (std::size_t rank : {0, 1}) CHECK(bytes[rank] == sent[rank] * std::int64_t(sizeof(double)) * 3 * 2);
}

TEST_CASE("copied columns stay up to date while all changes are announced") {
  using Columns = std::vector<std::size_t>;
  scree::detail::CurrentColumns columns;
  columns.renew(1);
  CHECK(columns.due({0, 1, 5}) == Columns{0, 1, 5});
  CHECK(columns.due({0, 1, 5}) == Columns{0, 5});  // positions alone are known outside of lists of passes
  columns.forget(true);
  CHECK(columns.due({0, 1, 5}) == Columns{0, 5});
  CHECK(columns.due({0, 1, 2, 5}) == Columns{2});
  columns.changed(5);
  CHECK(columns.due({0, 1, 2, 5}) == Columns{5});
  columns.changed(1);
  columns.changed(7);  // which was never copied
  CHECK(columns.due({1, 7}) == Columns{1, 7});
  columns.positions_changed();
  CHECK(columns.due({0, 1}) == Columns{1});
  columns.forget(true);
  CHECK(columns.due({0, 1}) == Columns{0});
  columns.renew(2);
  CHECK(columns.due({0, 1, 2}) == Columns{0, 1, 2});
  columns.forget(false);
  CHECK(columns.due({0, 2}) == Columns{0});
  CHECK(columns.due({0, 2}) == Columns{0});
}

}  // namespace scree::test::told_tests
