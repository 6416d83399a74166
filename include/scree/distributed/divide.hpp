// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../neighbours/grid.hpp"
#include "../rigid/state.hpp"
#include "by_identity.hpp"
#include "exchange.hpp"
#include "partition.hpp"
#include "team.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// Settings of the division of a case among ranks.
template <class Space>
struct DividedCase {
  std::optional<Team<Space>> team = {};  ///< if not set, the case has one rank
  /// The axis along which space is cut into slabs; if not set, recursive coordinate bisection is used.
  std::optional<int> slabs = {};
  /// The limit (-, above 1) on the ratio of the largest load of a rank to the mean load. The case is divided again if
  /// this ratio exceeds the limit and 1.05 times its value after the last division.
  double most_imbalance = 1.2;
  /// The relative cost of a particle of each body, in the order of the `bodies` of the formulation; the cost is 1 for
  /// bodies that are not listed.
  std::vector<int> costs = {4};
};

/// Event counts of a rank since the start.
struct RankCounts {
  std::int64_t divisions = 0;             ///< how often the case was divided
  std::int64_t migrated = 0, ghosts = 0;  ///< received: particles that migrated, and ghosts at all list builds
};

namespace detail {

/// Whether all ranks have all particles of a body and advance them identically, as for the states of rigid bodies. Such
/// a body has no ghosts and does not affect the division.
template <class P>
bool on_all_ranks(AnyParticles<P> const& body) {
  return body.has(RigidCentre{});
}
/// Returns the number of particles of a body that this rank contributes to a sum over all ranks.
template <class P>
std::int64_t counted_on(int rank, AnyParticles<P> const& body) {
  return on_all_ranks(body) && rank > 0 ? 0 : body.size();
}

template <int Dim>
struct PlainBox {
  std::array<double, Dim> low, high;  // m; low > high: empty
};

/// Counts the particles in each cell.
template <class P>
struct CountInGrid {
  Column<P, Position> x;
  CellOfPosition<P::dim> cell;
  Span<int> counts;
  SCREE_FN void operator()(int i) const { Kokkos::atomic_inc(&counts(cell(value_of(x(i))))); }
};

/// Data shared by the ghosts of all bodies on a rank.
template <class P>
class SharedByBodies {
  static constexpr int dim = P::dim;
  using Box = PlainBox<dim>;

 public:
  explicit SharedByBodies(DividedCase<typename P::space> const& settings)
      : team(settings.team ? *settings.team : team_of_one<typename P::space>()), settings_(settings) {
    check_setting(settings.most_imbalance > 1, "most_imbalance (-)", settings.most_imbalance, "above 1");
    for (int const cost : settings.costs) check_setting(cost > 0, "the cost of a particle", cost, "1 or more");
  }

  Team<typename P::space> team;
  Exchange<P> exchange;
  RankCounts counts;

  Partition<dim> const& partition() const { return partition_; }
  Span<typename Partition<dim>::Plane const> planes() const { return planes_; }
  /// Returns the bounding box of the particles on a rank.
  Box const& box(int rank) const { return boxes_[std::size_t(rank)]; }

  /// Divides the case while every rank has all particles, on the first call, and later if the loads are too unequal.
  void divide_if_due(double edge, bool scattered, AllBodiesRead<P> bodies);
  /// Finds the bounding box of the particles on each rank.
  void find_boxes(AllBodiesRead<P> bodies) { boxes_ = team.gather(box_around(bodies)); }

 private:
  int cost(std::size_t body) const { return body < settings_.costs.size() ? settings_.costs[body] : 1; }

  void divide(double edge, bool scattered, AllBodiesRead<P> bodies);
  static void add_weights(CellWeights<dim>& grid, AnyParticles<P> const& body, int cost);
  static Box box_around(AllBodiesRead<P> bodies);
  static void add(Box& box, AnyParticles<P> const& body);
  static void join(Box& box, Box const& other) {
    for (std::size_t axis = 0; axis < dim; ++axis) {
      box.low[axis] = std::min(box.low[axis], other.low[axis]);
      box.high[axis] = std::max(box.high[axis], other.high[axis]);
    }
  }

  DividedCase<typename P::space> settings_;
  Partition<dim> partition_;
  Array<P, typename Partition<dim>::Plane> planes_;
  std::vector<Box> boxes_;
  bool fresh_ = false;  // whether the case was divided since the last comparison of the loads
  double reached_ = 1;  // the imbalance after the last division
};

template <class P>
void SharedByBodies<P>::divide_if_due(double edge, bool scattered, AllBodiesRead<P> bodies) {
  if (!scattered || counts.divisions == 0) return divide(edge, scattered, bodies);
  std::int64_t mine = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    mine += std::int64_t(cost(k)) * (on_all_ranks(bodies[k]) ? 0 : bodies[k].size());
  double const now = imbalance(team.gather(mine));
  if (fresh_) reached_ = now;  // a division may not reach the required balance
  fresh_ = false;
  if (now > std::max(settings_.most_imbalance, 1.05 * reached_)) divide(edge, true, bodies);
}

template <class P>
void SharedByBodies<P>::divide(double edge, bool scattered, AllBodiesRead<P> bodies) {
  Box box = box_around(bodies);
  if (scattered)
    for (Box const& each : team.gather(box)) join(box, each);
  Vec<dim, double> low = zero<Vec<dim, double>>(), high = low;
  for (int axis = 0; axis < dim && box.low[0] <= box.high[0]; ++axis)
    low[axis] = box.low[std::size_t(axis)], high[axis] = box.high[std::size_t(axis)];
  auto grid = CellWeights<dim>::over(low, high, edge);
  for (std::size_t k = 0; k < bodies.size(); ++k) add_weights(grid, bodies[k], cost(k));
  if (scattered) grid.weights = team.sum(grid.weights);
  partition_ = settings_.slabs ? Partition<dim>::slabs(grid, team.ranks(), *settings_.slabs)
                               : Partition<dim>::bisection(grid, team.ranks());
  planes_ = array_of<P>(bodies[0].space(), partition_.planes());
  ++counts.divisions;
  fresh_ = true;
}

template <class P>
void SharedByBodies<P>::add_weights(CellWeights<dim>& grid, AnyParticles<P> const& body, int cost) {
  if (on_all_ranks(body)) return;
  Array<P, int> const found(body.space(), "scree::cell_weights", grid.weights.size());
  for_each_index(body.space(), "scree::cell_weights", 0, body.size(),
                 CountInGrid<P>{body.column(fields::position), CellOfPosition<dim>(grid), found});
  auto const numbers = scree::values_of(found);
  for (std::size_t c = 0; c < numbers.size(); ++c) grid.weights[c] += std::int64_t(cost) * numbers[c];
}

template <class P>
auto SharedByBodies<P>::box_around(AllBodiesRead<P> bodies) -> Box {
  Box box;
  box.low.fill(std::numeric_limits<double>::infinity());
  box.high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < bodies.size(); ++k) add(box, bodies[k]);
  return box;
}

template <class P>
void SharedByBodies<P>::add(Box& box, AnyParticles<P> const& body) {
  if (on_all_ranks(body) || body.size() == 0) return;
  auto const found =
      reduce(body.space(), "scree::bounding_box", body.size(), BoundingBox<P>{body.column(fields::position)});
  if (found.invalid > 0) refuse_positions(body.to_host(fields::position), found.invalid);
  Box other;
  for (std::size_t axis = 0; axis < dim; ++axis)
    other.low[axis] = double(found.low[axis]), other.high[axis] = double(found.high[axis]);
  join(box, other);
}

}  // namespace detail
}  // namespace scree
