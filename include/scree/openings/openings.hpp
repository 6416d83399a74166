// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../run/component.hpp"
#include "../snapshots/snapshot_of.hpp"
#include "inlet.hpp"
#include "open_end.hpp"
#include "passed.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The inlets and drains of a solver, with counts of the particles that have passed them.
namespace scree {

/// Settings of a drain.
struct Drain {
  std::string name = "drain";  ///< name in the ledger and in messages
  /// The distance (m) that a particle may move inside the drain before it is removed; 0: one support. Drains are
  /// emptied after neighbour-list builds, so a particle may move by half the skin in any case.
  double reach = 0;
};

namespace detail {

/// A receiver that ignores the particles of a drain.
struct Ignore {
  template <class List>
  void operator()(double, List const&) const {}
};

/// The inlets, drains and open ends of a solver of class `S`, which has a `State`. Layers are created and drains are
/// emptied between steps; the simulated time and the number of neighbour-list builds determine when.
template <class S, class State>
class Openings final : public Component<S> {
 public:
  static constexpr int dim = State::Basis::dim;
  using X = Vec<dim, double>;
  /// A function that creates particles at points and returns their volume (m^dim). The inlet with the given number
  /// holds the particles; 0: no inlet.
  using Make = std::function<double(State&, std::vector<X> const&, int)>;
  /// A function that releases the particles that the inlet with the given number holds and that have passed a plane
  /// perpendicular to a direction.
  using LetGo = std::function<void(State&, int, X const&, double)>;
  /// A function that removes the particles within a drain and adds them to its count.
  using Empty = std::function<void(State&, Passed&)>;
  /// A function that sets the given values on particles beyond an open end.
  using Keep = std::function<void(State&)>;

  void add(Inlet<dim> const& inlet, double spacing, double support, Make make, LetGo let_go) {
    InletColumn<dim> const column(inlet, spacing, support);
    require_name(inlet.name);
    std::string text = std::to_string(inlet.layer.size()) + " points" + (inlet.pushes ? ", pushes" : "") +
                       ", velocity" + exact(inlet.velocity) + " m/s, rate " + exact_text(inlet.rate) +
                       " m^dim/s, for " + exact_text(inlet.duration) + " s, from";
    text += exact(inlet.layer.front()) + " to" + exact(inlet.layer.back()) + " m";
    inlets_.push_back({column, inlet.pushes, text, std::move(make), std::move(let_go), {inlet.name}});
  }
  /// Adds a drain. `half_skin` is the distance (m) that particles may move between two neighbour-list builds; 0: any
  /// distance.
  void add(Drain const& drain, double support, double half_skin, Empty empty) {
    check_setting(drain.reach >= 0, "reach (m) of a drain", drain.reach, "0 or more");
    require_name(drain.name);
    double const reach = drain.reach > 0 ? drain.reach : support;
    long const builds = half_skin > 0 ? std::max(1L, long(reach / half_skin) - 1) : 0;
    drains_.push_back({builds, std::move(empty), {drain.name}});
  }
  /// Adds an open end, which is a drain with given values on the particles in front of it.
  void add(OpenEnd<dim> const& end, double support, double half_skin, Keep keep, Empty empty) {
    double const length = end.normal.norm();
    check_setting(length > 0 && std::isfinite(length), "length of the normal of an open end", length, "above 0");
    check_setting(end.point.allFinite(), "point (m) of an open end", end.point.sum(), "finite");
    add({.name = end.name}, support, half_skin, std::move(empty));
    ends_.push_back(
        {"end " + end.name + ": at" + exact(end.point) + " m, normal" + exact(end.normal), std::move(keep)});
  }

  void start(S& solver) override { keep(State::of(solver)); }
  bool is_due(S const& solver) const override {
    double const time = solver.time();
    long const builds = solver.neighbour_builds();
    for (auto const& inlet : inlets_)
      if (!inlet.open || inlet.column.layers_at(time - inlet.opened) > inlet.layers) return true;
    for (auto const& drain : drains_)
      if (builds >= checked_ + drain.builds || builds < checked_) return true;  // fewer builds: another search
    return false;
  }
  /// Empties all drains and feeds all inlets. They act together whenever one of them is due, because each change of
  /// particles costs a neighbour-list build. The rates of particles that enter are zero until the next step evaluates
  /// them.
  void act(S& solver) override {
    ProfilingRegion const region("scree::openings");
    State& state = State::of(solver);
    auto const before = state.system.template turnover<Material>();
    for (auto& drain : drains_) drain.empty(state, drain.passed);
    checked_ = solver.neighbour_builds();
    for (std::size_t k = 0; k < inlets_.size(); ++k) feed(state, inlets_[k], int(k) + 1, solver.time());
    if (before != state.system.template turnover<Material>()) state.particles_changed();
  }
  void after_step(S& solver) override { keep(State::of(solver)); }

  std::vector<Passed> entered() const { return passed(inlets_); }
  std::vector<Passed> left() const { return passed(drains_); }

  std::string signature() const override {
    std::string text;
    for (auto const& inlet : inlets_) text += "inlet " + inlet.passed.name + ": " + inlet.text + "\n";
    for (auto const& drain : drains_)
      text += "drain " + drain.passed.name + ": looks after " + std::to_string(drain.builds) + " builds\n";
    for (auto const& end : ends_) text += end.text + "\n";
    return text;
  }
  void save(Snapshot& snapshot) const override {
    if (are_none()) return;
    std::vector<double> numbers;
    for (auto const& inlet : inlets_) {
      add_counters(snapshot, "inlet " + inlet.passed.name,
                   {{"open", inlet.open}, {"layers", inlet.layers}, {"particles", inlet.passed.particles}});
      numbers.push_back(inlet.opened), numbers.push_back(inlet.passed.volume);
    }
    for (auto const& drain : drains_) {
      add_counters(snapshot, "drain " + drain.passed.name, {{"particles", drain.passed.particles}});
      numbers.push_back(drain.passed.volume);
    }
    add_counters(snapshot, "openings", {{"checked", checked_}});
    snapshot.arrays.push_back(filled(head(), numbers));
  }
  std::function<void(S&)> read(Snapshot const& snapshot) override {
    if (are_none()) return {};
    auto const numbers = values_of<double>(matching_array(snapshot, head()));
    if (numbers.size() != 2 * inlets_.size() + drains_.size())
      refuse(snapshot, "'" + head().name + "' has " + std::to_string(numbers.size()) + " values");
    for (double const number : numbers)
      if (!(number >= 0) || std::isinf(number)) refuse(snapshot, "'" + head().name + "' has " + exact_text(number));
    auto number = numbers.begin();
    auto inlets = inlets_;
    for (auto& inlet : inlets) {
      auto counts = counters_of(snapshot, "inlet " + inlet.passed.name);
      inlet.open = counts["open"] != 0, inlet.layers = counts["layers"];
      inlet.opened = *number++;
      inlet.passed.particles = counts["particles"], inlet.passed.volume = *number++;
      if (inlet.layers != (inlet.open ? inlet.column.layers_at(snapshot.time - inlet.opened) : 0) ||
          inlet.passed.particles != inlet.column.particles_in(inlet.layers))
        refuse(snapshot, "inlet '" + inlet.passed.name + "' has made " + std::to_string(inlet.layers) + " layers of " +
                             std::to_string(inlet.passed.particles) +
                             " particles, which does not follow from its rate and the time");
    }
    auto drains = drains_;
    long removed = counters_of(snapshot, std::string(Material::name) + " particles")["removed"];
    for (auto& drain : drains) {
      drain.passed.particles = counter_within(snapshot, "drain " + drain.passed.name + "/particles", 0, removed);
      removed -= drain.passed.particles;
      drain.passed.volume = *number++;
    }
    auto const builds = snapshot.counters.find("neighbours/builds");
    long const checked =
        counter_within(snapshot, "openings/checked", 0, builds == snapshot.counters.end() ? 1L << 62 : builds->second);
    return [this, inlets, drains, checked](S&) { inlets_ = inlets, drains_ = drains, checked_ = checked; };
  }

 private:
  struct OfInlet {
    InletColumn<dim> column;
    bool pushes;
    std::string text;
    Make make;
    LetGo let_go;
    Passed passed;
    bool open = false;
    double opened = 0;  // s
    long layers = 0;
  };
  struct OfDrain {
    long builds;
    Empty empty;
    Passed passed;
  };
  struct End {
    std::string text;
    Keep keep;
  };
  static SnapshotArray head() { return head_of<double>("openings/opened and volumes", "s, m^dim"); }
  static std::string exact(X const& x) {
    std::string text;
    for (int axis = 0; axis < dim; ++axis) (text += ' ') += exact_text(x[axis]);
    return text;
  }
  template <class All>
  static std::vector<Passed> passed(All const& all) {
    std::vector<Passed> list;
    for (auto const& each : all) list.push_back(each.passed);
    return list;
  }
  void require_name(std::string const& name) const {
    if (name.empty() || name.find_first_of(":/\n") != std::string::npos)
      throw std::invalid_argument("scree: '" + name +
                                  "' is no name of an inlet or drain: it needs a character at "
                                  "least, and no line break, colon or slash");
    for (auto const& all : {entered(), left()})
      for (auto const& each : all)
        if (each.name == name)
          throw std::invalid_argument("scree: there is an inlet or drain with the name '" + name +
                                      "' already: give another `.name`");
  }
  /// Whether there are neither inlets nor drains, because the first one was rejected.
  bool are_none() const { return inlets_.empty() && drains_.empty(); }
  /// Sets the given values on particles beyond open ends.
  void keep(State& state) const {
    for (auto const& end : ends_) end.keep(state);
  }
  void feed(State& state, OfInlet& inlet, int number, double time) {
    if (!inlet.open) inlet.open = true, inlet.opened = time;
    double const since = time - inlet.opened;
    long const wanted = inlet.column.layers_at(since);
    if (wanted == inlet.layers) return;
    if (inlet.pushes) inlet.let_go(state, number, inlet.column.direction(), inlet.column.held_up_to(since));
    std::vector<X> points;
    for (; inlet.layers < wanted; ++inlet.layers)
      for (X const& x : inlet.column.points(inlet.layers, since)) points.push_back(x);
    if (points.empty()) return;
    inlet.passed.volume += inlet.make(state, points, inlet.pushes ? number : 0);
    inlet.passed.particles += long(points.size());
  }

  std::vector<OfInlet> inlets_;
  std::vector<OfDrain> drains_;
  std::vector<End> ends_;
  long checked_ = 0;  // number of builds when the drains were last emptied
};

}  // namespace detail
}  // namespace scree
