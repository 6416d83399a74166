// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../motion/motion.hpp"
#include "../system/periodic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace scree {

/// The distance by which a particle is outside of a box, m.
template <class X>
struct DistanceBeyond {
  X low, high;
  using reads = Fields<Position>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    using namespace fields;
    typename X::Scalar distance = 0;
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis)
      distance = Kokkos::max(distance, Kokkos::max(low[axis] - i[position][axis], i[position][axis] - high[axis]));
    return distance;
  }
};

namespace detail {
/// Extends a box to a point. The element-wise code compiles faster.
template <class X>
void extend(X& low, X& high, X const& x) {
  for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) {
    low[axis] = std::min(low[axis], x[axis]);
    high[axis] = std::max(high[axis], x[axis]);
  }
}
/// Returns the low and the high corner of the box around some points; nothing if there are no points.
template <class X>
[[gnu::cold]] std::vector<X> corners_of(std::vector<X> const& points) {
  if (points.empty()) return {};
  X low = points.front(), high = low;
  for (X const& x : points) extend(low, high, x);
  return {low, high};
}
}  // namespace detail

/// The box outside of which material is lost. It contains the walls, at their initial and present positions, and the
/// positions given to the material. It is open above (the last coordinate), where grains may fly, and along periods.
/// Without walls nothing is lost. `Count` is the number of bodies; walls may belong to any of them.
template <class P, std::size_t Count>
class Confines {
 public:
  using vector = Vec<P::dim, typename P::real>;

  /// Makes a domain with these periods, to which walls and material are then added.
  explicit Confines(std::vector<Period> const& periods) : periods_(periods) {}
  /// Extends the box of the material to points, m.
  void add_material(std::vector<vector> const& points) { material_.add(points); }
  /// Returns the low and the high corner of the box around the positions given to the material, which must not be
  /// empty.
  std::vector<vector> material() const { return {material_.low, material_.high}; }
  /// Adds the walls of a body at time zero, in parts each of which moves as a whole.
  void add_wall(std::size_t body, std::vector<std::vector<vector>> const& parts) {
    auto& walls = walls_[body];
    walls.resize(std::max(walls.size(), parts.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) walls[k].add(parts[k]);
  }

  /// Returns the box at a time (s), given the motion of each body.
  template <class... Motions>
  [[gnu::cold]] DistanceBeyond<vector> at(double time, Motions const&... motions) const {
    static_assert(sizeof...(Motions) == Count);
    using real = typename P::real;
    real const infinity = std::numeric_limits<real>::infinity();
    Hull all;
    std::size_t body = 0;
    (add_walls(all, walls_[body++], motions, time), ...);
    if (all.empty()) return {same(-infinity), same(infinity)};
    if (!material_.empty()) all.add({material_.low, material_.high});
    all.high[P::dim - 1] = infinity;
    for (Period const& period : periods_) all.low[period.axis] = -infinity, all.high[period.axis] = infinity;
    return {all.low, all.high};
  }
  /// Returns the largest magnitude of a coordinate, m, among walls at time zero, walls at a time (s), and the positions
  /// given to the material.
  template <class... Motions>
  [[gnu::cold]] double farthest(double time, Motions const&... motions) const {
    Hull all;
    std::size_t body = 0;
    (add_walls(all, walls_[body++], motions, time), ...);
    if (!material_.empty()) all.add({material_.low, material_.high});
    double largest = 0;
    for (int axis = 0; axis < P::dim && !all.empty(); ++axis)
      largest = std::max({largest, std::abs(double(all.low[axis])), std::abs(double(all.high[axis]))});
    return largest;
  }

 private:
  static vector same(typename P::real value) {
    vector x;
    for (int axis = 0; axis < P::dim; ++axis) x[axis] = value;
    return x;
  }
  struct Hull {
    vector low = same(std::numeric_limits<typename P::real>::infinity()), high = same(-low[0]);
    [[gnu::cold]] void add(std::vector<vector> const& points) {
      for (auto const& x : points) detail::extend(low, high, x);
    }
    bool empty() const { return !(low[0] <= high[0]); }
    [[gnu::cold]] std::vector<vector> corners() const {
      std::vector<vector> all;
      for (int corner = 0; corner < 1 << P::dim; ++corner) {
        vector x;
        for (int axis = 0; axis < P::dim; ++axis) x[axis] = (corner >> axis & 1) != 0 ? high[axis] : low[axis];
        all.push_back(x);
      }
      return all;
    }
  };
  /// Adds the corners of walls at time zero and at another time (s).
  template <class Motion>
  [[gnu::cold]] static void add_walls(Hull& all, std::vector<Hull> const& parts, Motion const& motion, double time) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].empty()) continue;
      for (vector const& x : parts[k].corners())
        all.add({x, vector(motion_of_group(motion, static_cast<int>(k)).displaced(x, 0.0, time))});
    }
  }

  std::vector<Period> periods_;
  Hull material_;
  std::array<std::vector<Hull>, Count> walls_;  // at time zero, of each body and part
};

}  // namespace scree
