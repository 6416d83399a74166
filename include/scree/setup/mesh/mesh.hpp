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

/// A body bounded by triangles, as a shape. Points at which the generalised winding number exceeds 1/2 are inside
/// (`mesh/winding.hpp`), so that small holes are allowed. Closed shells that touch or overlap are replaced by their
/// union: parts of the surface inside it are left out (`mesh/unite.hpp`). Copies share their data; host only.
///
/// The constructor joins vertices, drops triangles without area, turns over triangles and closed shells where this is
/// certain, and forms the union; report() lists these changes. It throws std::runtime_error with the file and the
/// triangle if no triangle has an area, if the surface has only one side, if more than a tenth of the area has no
/// inside behind it, or if closed shells that touch or overlap cannot be oriented or united.
class Mesh {
 public:
  static constexpr int dim = 3;
  static constexpr char const* name = "Mesh";
  static constexpr bool costly_distance = true;

  /// Makes a body of the inside of a surface. Throws std::runtime_error if the triangles do not enclose one.
  explicit Mesh(Triangles triangles);

  /// Returns the distance from the nearest triangle of the union, exact to rounding, negative inside, m. In a mesh with
  /// holes, for which no union is formed, the distance is a lower bound inside where shells overlap.
  double signed_distance(Vec<3, double> const& x) const;
  /// Whether the signed distance may jump: it changes its sign in the holes of a mesh.
  bool has_jumps() const { return !report().closed; }
  /// The signed distance for successive points that are close to each other. The search starts from the triangle
  /// nearest to the previous point. In a closed mesh, a point is on the same side as the previous one if no triangle is
  /// between them.
  class Walk;
  Walk walk() const;
  bool contains(Vec<3, double> const& x) const;
  Box<3> bounds() const { return report().bounds; }
  /// Returns the unit vector along the line through x and the nearest point of the surface, outwards; on the surface,
  /// the normal of the triangle.
  Vec<3, double> outward_normal(Vec<3, double> const& x) const;

  /// Returns the nearest point of the surface, its triangle and its distance.
  SurfacePoint nearest(Vec<3, double> const& x) const;
  /// Returns the winding number: 1 inside and 0 outside of a closed surface. In a mesh with holes it is between 0 and 1
  /// near a hole and 2 where two shells overlap; its error is up to 0.25, and less near 1/2.
  double winding_number(Vec<3, double> const& x) const;
  /// Returns the volume (m^3) below a level of the last coordinate (m), exact by the divergence theorem; no value for a
  /// mesh with holes.
  std::optional<double> exact_volume_below(double level) const;
  /// Returns the triangles of the boundary of the union, each with its number in the file.
  Triangles const& triangles() const;
  /// Returns the report on the faults that were found and repaired when the mesh was made.
  MeshReport const& report() const;

 private:
  double signed_distance(SurfacePoint const& there, bool inside) const;
  bool is_inside(Vec<3, double> const& x, SurfacePoint const& there) const;
  /// Whether x may be so near to a triangle of a closed surface that rounding changes its winding number.
  bool is_at_surface(Vec<3, double> const& x) const;
  bool is_enclosed(Vec<3, double> const& x) const;
  /// Returns the distance in front of a triangle at which its surroundings are probed, m.
  double front() const { return 1e-6 * (bounds().high - bounds().low).maxCoeff(); }
  Vec<3, double> normal_of(SurfacePoint const& there) const;
  /// Returns 1 outside and -1 inside if this is certain without a winding number: on the normal of the nearest triangle
  /// of a surface without a hole. Returns 0 elsewhere.
  int side_of_face(SurfacePoint const& there, Vec<3, double> const& x) const;
  /// Whether a point of a surface with holes is within another shell, and therefore not on the boundary.
  bool is_buried(SurfacePoint const& there) const;

  std::shared_ptr<detail::MeshData const> data_;
};

class Mesh::Walk {
 public:
  /// Starts without a previous point. Holds a copy of the mesh, which shares its data.
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
