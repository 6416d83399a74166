// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/shape.hpp"
#include "report.hpp"
#include "tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace scree {

namespace detail {
struct MeshData;
}  // namespace detail

/// A body bounded by triangles, as a shape. Inside is where the generalised winding number exceeds 1/2
/// (`mesh/winding.hpp`), so small holes are allowed. Closed shells that touch or overlap are their union: parts of the
/// surface within it are left out (`mesh/unite.hpp`). Copies share their data; host only.
///
/// The constructor joins vertices, drops triangles without area, turns over triangles and closed shells where this is
/// certain, and forms the union; report() lists these changes. It throws std::runtime_error with the file and the
/// triangle if no triangle has an area, if the surface has only one side, or if more than a tenth of the area has no
/// inside behind it.
class Mesh {
 public:
  static constexpr int dim = 3;
  static constexpr char const* name = "Mesh";
  static constexpr bool costly_distance = true;

  /// Makes the solid inside of a surface. Throws std::invalid_argument if the triangles do not enclose one.
  explicit Mesh(Triangles triangles);

  /// Distance from the nearest triangle of the union, exact to rounding, negative inside, m. In a mesh with holes no
  /// union is formed: there it is a lower bound inside where shells overlap.
  double signed_distance(Vec<3, double> const& x) const;
  /// Whether the signed distance jumps: in holes of a mesh it changes its sign.
  bool has_jumps() const { return !report().closed; }
  /// signed_distance() for points of which successive ones are close. It starts from the last nearest triangle, and a
  /// point is on the side of the last one if no triangle of a closed surface is between them.
  class Walk;
  Walk walk() const;
  bool contains(Vec<3, double> const& x) const;
  Box<3> bounds() const { return report().bounds; }
  /// The direction from or to the nearest point, outwards; on the surface the normal of the triangle.
  Vec<3, double> outward_normal(Vec<3, double> const& x) const;

  /// The nearest point of the surface, its triangle and its distance.
  SurfacePoint nearest(Vec<3, double> const& x) const;
  /// 1 inside and 0 outside of a closed surface. Between them near holes; there it has an error of up to 0.25, and less
  /// near 1/2, and is 2 where two shells overlap.
  double winding_number(Vec<3, double> const& x) const;
  /// The volume below a level of the last coordinate (m), exact by the divergence theorem, m^3; none for a mesh with
  /// holes.
  std::optional<double> exact_volume_below(double level) const;
  /// The boundary of the union, each with its number in the file.
  Triangles const& triangles() const;
  /// The faults that were found, and those that were repaired, when the mesh was read.
  MeshReport const& report() const;

 private:
  double signed_distance(SurfacePoint const& there, bool inside) const;
  bool is_inside(Vec<3, double> const& x, SurfacePoint const& there) const;
  /// Whether x may be so near to a triangle of a closed surface that rounding changes its winding number.
  bool is_at_surface(Vec<3, double> const& x) const;
  bool is_enclosed(Vec<3, double> const& x) const;
  /// The distance in front of a triangle at which its surroundings are probed, m.
  double front() const { return 1e-6 * (bounds().high - bounds().low).maxCoeff(); }
  Vec<3, double> normal_of(SurfacePoint const& there) const;
  /// 1 outside, -1 inside where this is certain without a winding number: on the normal of the nearest triangle of a
  /// surface without a hole. 0 elsewhere.
  int side_of_face(SurfacePoint const& there, Vec<3, double> const& x) const;
  /// Whether a point of a surface with holes is within another shell and so on no boundary.
  bool is_buried(SurfacePoint const& there) const;

  std::shared_ptr<detail::MeshData const> data_;
};

class Mesh::Walk {
 public:
  /// Begins without a last point. The mesh must outlive the walk.
  explicit Walk(Mesh const& mesh) : mesh_(mesh) {}
  double operator()(Vec<3, double> const& x);

 private:
  long number_at(Vec<3, double> const& x) const;
  long number_from_last(Vec<3, double> const& x) const;
  Mesh mesh_;
  Vec<3, double> x_ = Vec<3, double>::Zero();
  SurfacePoint there_;
  long around_ = 0;  // winding number of a closed surface
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "mesh.ipp"
#endif
