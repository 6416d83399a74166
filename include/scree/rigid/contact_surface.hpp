// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../motion/motion.hpp"
#include "../neighbours/cell_list.hpp"
#include "../pairs/for_each_pair.hpp"
#include "contact_terms.hpp"

#include <vector>

// The surfaces of rigid bodies and walls: their normals are computed once from the particle positions at time zero and
// then rotated with the motion.
namespace scree::detail {

struct Emptiness : Vector<"emptiness", "1/m"> {};
struct Fullness : Scalar<"fullness", "1"> {};
struct AlikeNormals : Vector<"alike normals", "1"> {};
struct AlikeWeight : Scalar<"alike weight", "1"> {};

/// Pair term for the sums sum V W and -sum V grad W over the particles of the same body.
struct OwnSums {
  using reads = Fields<Group>;
  using reads_j = Fields<Volume>;
  using adds = Fields<Fullness, Emptiness>;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    if (i[group] != j[group]) return;
    sum[Fullness{}] += j[volume] * ij.W();
    if (ij.r > 0) sum[Emptiness{}] += -j[volume] * ij.gradW();
  }
};
/// Computes the unit normal; it is zero inside a body and where the body is thinner than two particles.
struct NormalOfSums {
  double least;  ///< 1/m
  using reads = Fields<>;
  using writes = Fields<Facing, Fullness>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    auto const G = total[Emptiness{}];
    using X = std::remove_cvref_t<decltype(G)>;
    auto const length = norm(G);
    out[fields::facing] = double(length) > least ? X(G / length) : zero<X>();
    out[Fullness{}] = total[Fullness{}];
  }
};
/// Pair term for the mean of the normals on one side of a body. The length of this mean is less than 1 if the normals
/// differ.
struct AlikeSums {
  using reads = Fields<Group, Facing>;
  using reads_j = Fields<Volume>;
  using adds = Fields<AlikeNormals, AlikeWeight>;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    if (i[group] != j[group] || !(dot(i[facing], j[facing]) > 0)) return;
    auto const w = j[volume] * ij.W();
    sum[AlikeWeight{}] += w;
    sum[AlikeNormals{}] += w * j[facing];
  }
};
struct FlatnessOfSums {
  using reads = Fields<Facing>;
  using writes = Fields<RestFacing>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    auto const weight = total[AlikeWeight{}];
    out[rest_facing] = zero<std::remove_cvref_t<decltype(i[facing])>>();
    if (weight > 0) out[rest_facing] = norm(total[AlikeNormals{}]) / weight * i[facing];
  }
};

/// The surface of a body at time zero.
template <class X>
struct SurfaceAtRest {
  std::vector<X> facing;
  std::vector<int> owner;
  std::vector<bool> outermost;
};

/// Returns a provider of ghosts within a radius (m) for particles that are all on this rank. Providers of ghosts from
/// other ranks have a function images_within(radius) for this purpose.
template <class Ghosts>
auto images_at_rest(Ghosts const& ghosts_of_system, double radius) {
  if constexpr (requires { ghosts_of_system.images_within(radius); })
    return ghosts_of_system.images_within(radius);
  else
    return Ghosts(ghosts_of_system.settings(), radius, 0);
}

/// Returns the surface of particles at their rest positions, from sums over the particles of the same group within two
/// spacings. A larger radius would tilt the normals of a side near its edges.
template <class P, class Ghosts, class X>
[[gnu::cold]] SurfaceAtRest<X> surface_at_rest(typename P::space const& space, Ghosts const& ghosts_of_system,
                                               double spacing, std::vector<X> const& at_rest,
                                               std::vector<int> const& owners) {
  using namespace fields;
  using Body = Particles<P, Fields<Position, Volume, Group, Facing, RestFacing, Fullness>>;
  kernel_of<P> const kernel((2 - 1e-6) * spacing / P::kernel::support);
  Body body(space, int(at_rest.size()));
  body.from_host(position, at_rest);
  body.from_host(group, owners);
  body.fill(volume, typename P::real(math::power<P::dim>(spacing)));
  auto images = images_at_rest(ghosts_of_system, double(kernel.radius()));
  images.create(body);
  images.refresh(body, body.numbers_of(Fields<Position, Volume, Group>{}));
  CellList<P> cells(double(kernel.radius()));
  auto const all = body[position];
  cells.update(all.part(0, body.size()), all);
  for_each_pair(PairLoopOptions<P, Everywhere, NormalOfSums>{"scree::normals", kernel, {}, {0.05 / spacing}}, body,
                from(body, cells, OwnSums{}));
  images.refresh(body, body.numbers_of(Fields<Position, Facing>{}));
  for_each_pair(PairLoopOptions<P, Everywhere, FlatnessOfSums>{"scree::flatness", kernel, {}, {}}, body,
                from(body, cells, AlikeSums{}));
  SurfaceAtRest<X> result{body.to_host(rest_facing), owners, {}};
  auto const fullness = body.to_host(Fullness{});
  double const full = kernel_sum_of_lattice(kernel, spacing);
  for (std::size_t k = 0; k < owners.size(); ++k) {
    bool const outermost = double(fullness[k]) < 0.95 * full;
    if (!outermost) result.owner[k] = ContactLaw::inside;
    result.outermost.push_back(outermost);
  }
  return result;
}

/// Rotates normals with the motion, by the cofactors of the deformation gradient, so that shearing motions are covered,
/// too.
template <class Motion>
struct TurnFacing {
  Motion motion;
  double time, length;  ///< s, m
  using reads = Merge<Fields<RestPosition, RestFacing>, fields_of_motion<Motion>>;
  using writes = Fields<Facing>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using X = std::remove_cvref_t<decltype(i[rest_facing])>;
    using Real = typename X::Scalar;
    constexpr int dim = X::RowsAtCompileTime;
    auto const& own = motion_of(motion, i);
    X const x = own.displaced(i[rest_position], 0.0, time);
    Mat<dim, Real> F;
    for (int axis = 0; axis < dim; ++axis) {
      X there = i[rest_position];
      there[axis] += Real(length);
      X const column = own.displaced(there, 0.0, time) - x;
      for (int row = 0; row < dim; ++row) F(row, axis) = column[row] / Real(length);
    }
    X const n = cofactors(F) * i[rest_facing];
    Real const before = norm(i[rest_facing]), after = norm(n);
    out[facing] = after > 0 ? X(n * (before / after)) : n;
  }

 private:
  template <class Real>
  SCREE_FN static Mat<2, Real> cofactors(Mat<2, Real> const& F) {
    Mat<2, Real> C;
    C(0, 0) = F(1, 1), C(0, 1) = -F(1, 0), C(1, 0) = -F(0, 1), C(1, 1) = F(0, 0);
    return C;
  }
  template <class Real>
  SCREE_FN static Mat<3, Real> cofactors(Mat<3, Real> const& F) {
    Mat<3, Real> C;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        int const a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
        C(a, b) = F(a1, b1) * F(a2, b2) - F(a1, b2) * F(a2, b1);
      }
    return C;
  }
};

}  // namespace scree::detail
