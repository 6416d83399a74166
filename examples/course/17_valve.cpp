// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A component of your own that acts during a run: a valve under a silo opens, and closes when a given mass has left.
//
//   course_17_valve [mass in kg per m] [duration in s]
//
// In ParaView, particles.vtkhdf coloured by velocity shows how the slide under the slot moves aside, the silo empties,
// and the slide comes back and retains the rest. In valve.csv the mass below the slot grows at a constant rate to a
// little above the given mass, because grains still flow while the slide closes, and then stays constant. The component
// is saved with the solver, so an interrupted run continues with the same bits.
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/steered.hpp>
#include <scree/openings/regions.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <memory>

using namespace scree;

struct Silo : Formulation<2> {
  using physics = Granular<>;
  using motion = MotionOfGroups<2, Steered<2>>;  // a motion whose velocity can change during the run
  using integrator = SymplecticEuler;
};
using S = Solver<Silo>;

double const slot = 0.03, width = 0.12, height = 0.15, dr = 0.003, rho = 1500;  // m, kg/m^3

/// A component that sets the velocity of the slide between time steps.
class Valve : public Component<S> {
 public:
  Valve(int slide, double wanted) : slide_(slide), wanted_(wanted) {}

  bool is_due(S const& solver) const override { return solver.time() >= next_; }
  void act(S& solver) override {
    double const now = solver.time(), way = motion_.displaced(Vec<2, double>(0, 0), 0.0, now)[0];
    closes_ = closes_ || rho * solver.left()[0].volume >= wanted_;
    double const speed = now < 0.1 ? 0 : closes_ ? (way > 0 ? -1 : 0) : (way < slot + 3 * dr ? 1 : 0);  // m/s
    next_ = now + 0.001;
    give(solver, motion_.turned_to({speed, 0}, now));
  }
  void save(Snapshot& snapshot) const override {
    auto numbers = motion_.numbers();
    numbers.insert(numbers.end(), {next_, double(closes_)});
    add_numbers(snapshot, "valve", unit, numbers);
  }
  std::function<void(S&)> read(Snapshot const& snapshot) override {
    std::size_t const own = Steered<2>::number_count;
    auto const numbers = numbers_of(snapshot, "valve", unit, own + 2);
    return [=, this, motion = Steered<2>::from_numbers(numbers)](S& solver) {
      next_ = numbers[own], closes_ = numbers[own + 1] != 0;
      give(solver, motion);
    };
  }

 private:
  static constexpr char const* unit = "s, m, m/s, s, 1";
  void give(S& solver, Steered<2> const& motion) {
    motion_ = motion;
    auto all = solver.settings().motion;
    solver.set_motion(all.set(slide_, motion));
  }
  int slide_;
  double wanted_, next_ = 0;  // kg/m, s
  bool closes_ = false;
  Steered<2> motion_;
};

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const wanted = argument<double>(argc, argv, 1, 6);
  double const duration = argument<double>(argc, argv, 2, 1);

  double const left = (width - slot) / 2, right = left + slot, thick = 3 * dr;
  auto const floor = [&](double from, double to) { return Box<2>{{from, -thick}, {to, 0}}; };
  auto const side = [&](double x) { return Box<2>{{x, 0}, {x + thick, 1.2 * height}}; };
  std::vector<Vec<2, double>> vessel;
  for (auto const& box : {floor(-thick, left), floor(right, width + thick), side(-thick), side(width)})
    for (auto const& x : fill_lattice(box, dr)) vessel.push_back(x);
  Groups<2> walls;
  walls.add("vessel", vessel);
  walls.add("slide", fill_lattice(Box<2>{{left - thick, -2 * thick}, {right + thick, -thick}}, dr));

  MuOfI<> const sand{.elastic = {.young = 3e5, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 1e-3}};
  S solver({.spacing = dr, .physics = {.law = sand, .cfl = 0.6}, .motion = MotionOfGroups<2, Steered<2>>(walls)},
           fill_lattice(Box<2>{{0, 0}, {width, height}}, dr), walls);
  Geostatic const at_rest{height, rho, 9.81, 0.75};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });
  solver.drain({.name = "below", .reach = dr / 2}, Beyond<2>{{0, -7 * dr}, {0, -1}});
  solver.attach(std::make_shared<Valve>(walls.number("slide"), wanted));

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("valve.csv", {{"time", "s"}, {"mass out", "kg/m"}, {"way of the slide", "m"}});
  double const x0 = solver.wall().to_host(position).back()[0];
  solver.run(
      duration,
      {every<S>(0.01,
                [&](S& now) {
                  table.row({now.time(), rho * now.left()[0].volume, now.wall().to_host(position).back()[0] - x0});
                }),
       every<S>(duration / 50, [&](S& now) { output.append(now); })});
}
