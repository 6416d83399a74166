// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/shape.hpp"
#include "inspect.hpp"
#include "volume_below.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace scree {

namespace detail {

/// Area and volume, by the divergence theorem.
inline void measure(MeshReport& report, Triangles const& mesh) {
  Vec<3, double> const middle = (report.bounds.low + report.bounds.high) / 2;
  report.area = report.volume = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Vec<3, double> const area = mesh.area_vector(t);
    report.area += area.norm();
    report.volume += (mesh.vertex(t, 0) - middle).dot(area) / 3;
  }
}

/// Changes the triangles where this is certain and finds what can be said without their tree.
inline MeshReport prepare(Triangles& mesh) {
  MeshReport report{.name = mesh.name, .triangles_read = long(mesh.size())};
  auto const refuse = [&] { throw std::runtime_error(mesh.name + ": there is no triangle with an area"); };
  if (mesh.size() == 0) refuse();
  report.welded_vertices = weld(mesh);
  report.degenerate_triangles = drop_degenerate(mesh);
  report.triangles = long(mesh.size());
  if (mesh.size() == 0) refuse();
  report.orientation = orient(mesh);
  report.closed = is_closed(mesh);
  report.bounds = bounds_of(mesh);
  measure(report, mesh);
  return report;
}

/// A triangulated surface with its report, the hierarchy of its triangles and their moments.
struct MeshData {
  Triangles triangles;
  MeshReport report;
  TriangleTree tree;
  WindingNumbers winding;

  explicit MeshData(Triangles mesh)
      : triangles(std::move(mesh)), report(prepare(triangles)), tree(triangles), winding(tree) {
    auto const behind = numbers_behind(triangles, tree, winding, report.closed);
    check_inside(report, triangles, behind);
    check_bounded();
    if (report.closed) unite(behind);
    report.wall = least_facing(triangles, tree, -1);
    report.gap = least_facing(triangles, tree, 1);
  }

 private:
  /// Throws std::runtime_error if too much of the area has no inside behind it.
  void check_bounded() const {
    auto const refuse = [&](char const* why) {
      throw std::runtime_error(formatted("%s: %.3g %% of the area has no inside behind it: %s",
                                         report.first_unbounded.c_str(), 100 * report.unbounded_share, why));
    };
    bool const touching = report.closed && !report.orientation.crowded_edges.empty();
    if (touching && report.unbounded_share > 1e-4)
      refuse("shells that touch at an edge have unlike orientations; turn over those that are inside out");
    if (report.unbounded_share > 0.1)
      refuse(formatted("this is a sheet, a body with large holes or one whose triangles point inwards; there are %zu "
                       "open edges",
                       report.orientation.open_edges.size())
                 .c_str());
  }
  /// Leaves the boundary of the union of all shells.
  void unite(std::vector<double> const& behind) {
    auto united = ShellUnion(triangles, tree, winding, behind)();
    if (united.left_out == 0) return;
    if (report.orientation.nested_shells > 0 && united.inverted > 1e-6 * report.area)
      throw std::runtime_error(united.first_inverted +
                               ": this closed shell is inside out and reaches out of the others: turn it over");
    report.buried_share = united.left_out / report.area, report.first_buried = united.first_left_out;
    triangles = std::move(united.triangles), tree = TriangleTree(triangles), winding = WindingNumbers(tree);
    measure(report, triangles);
    check_united();
  }
  /// Throws std::runtime_error unless the triangles separate inside from outside.
  void check_united() const {
    auto const numbers = numbers_behind(triangles, tree, winding, true);
    double wrong = 0;
    Vec<3, double> sum = Vec<3, double>::Zero();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      Vec<3, double> const area = triangles.area_vector(t);
      sum += area;
      if (numbers[t] != 1) wrong += area.norm();
    }
    if (sum.norm() + wrong > 1e-4 * report.area)
      throw std::runtime_error(report.first_buried +
                               ": this shell touches or overlaps another one, and their union could not be formed: "
                               "unite them in the program that drew them");
  }
};

}  // namespace detail

/// A body bounded by triangles, as a shape. Inside is where the generalised winding number exceeds 1/2
/// (`mesh/winding.hpp`), so small holes are allowed. Closed shells that touch or overlap are their union: parts of the
/// surface within it are left out (`mesh/unite.hpp`). Copies share their data; host only.
///
/// The constructor joins vertices, drops triangles without area, turns over triangles and closed shells where this is
/// certain, and forms the union; report() says what it did. It throws std::runtime_error with the file and the triangle
/// if no triangle has an area, if the surface has only one side, or if more than a tenth of the area has no inside
/// behind it.
class Mesh {
 public:
  static constexpr int dim = 3;
  static constexpr char const* name = "Mesh";
  static constexpr bool costly_distance = true;

  explicit Mesh(Triangles triangles) : data_(std::make_shared<detail::MeshData const>(std::move(triangles))) {}

  /// Distance from the nearest triangle of the union, exact to rounding, negative inside, m. In a mesh with holes no
  /// union is formed: there it is a lower bound inside where shells overlap.
  double signed_distance(Vec<3, double> const& x) const {
    SurfacePoint const there = nearest(x);
    return signed_distance(there, is_inside(x, there));
  }
  /// It changes its sign within holes.
  bool has_jumps() const { return !report().closed; }
  /// signed_distance() for points of which successive ones are close. It starts from the last nearest triangle, and a
  /// point is on the side of the last one if no triangle of a closed surface is between them.
  class Walk;
  Walk walk() const;
  bool contains(Vec<3, double> const& x) const {
    if (!bounds().contains(x)) return false;
    return is_at_surface(x) ? signed_distance(x) < 0 : is_enclosed(x);
  }
  Box<3> bounds() const { return report().bounds; }
  /// The direction from or to the nearest point, outwards; on the surface the normal of the triangle.
  Vec<3, double> outward_normal(Vec<3, double> const& x) const {
    SurfacePoint const there = nearest(x);
    Vec<3, double> const away = x - there.point;
    if (!(there.distance > 1e-6 * front())) return normal_of(there);
    return away * ((is_inside(x, there) ? -1 : 1) / there.distance);
  }

  SurfacePoint nearest(Vec<3, double> const& x) const { return data_->tree.nearest(x); }
  /// 1 inside and 0 outside of a closed surface. Between them near holes; there it has an error of up to 0.25, and less
  /// near 1/2, and is 2 where two shells overlap.
  double winding_number(Vec<3, double> const& x) const { return data_->winding(data_->tree, x, report().closed); }
  /// The volume below a level of the last coordinate (m), exact by the divergence theorem, m^3; none for a mesh with
  /// holes.
  std::optional<double> exact_volume_below(double level) const {
    if (!report().encloses_exactly()) return std::nullopt;
    return detail::volume_below(triangles(), level);
  }
  /// The boundary of the union, each with its number in the file.
  Triangles const& triangles() const { return data_->triangles; }
  MeshReport const& report() const { return data_->report; }

 private:
  double signed_distance(SurfacePoint const& there, bool inside) const {
    if (!inside) return there.distance;
    return -(is_buried(there) ? std::max(there.distance, front()) : there.distance);
  }
  bool is_inside(Vec<3, double> const& x, SurfacePoint const& there) const {
    int const side = side_of_face(there, x);
    return side != 0 ? side < 0 : is_enclosed(x);
  }
  /// Whether x may be so near to a triangle of a closed surface that rounding changes its winding number.
  bool is_at_surface(Vec<3, double> const& x) const {
    Box<3> const around = detail::grown(Box<3>{x, x}, 1e-6 * front());
    return report().closed && !data_->tree.visit_box(around, [](int) { return false; });
  }
  bool is_enclosed(Vec<3, double> const& x) const { return bounds().contains(x) && winding_number(x) > 0.5; }
  /// How far in front of a triangle its surroundings are probed, m.
  double front() const { return 1e-6 * (bounds().high - bounds().low).maxCoeff(); }
  Vec<3, double> normal_of(SurfacePoint const& there) const {
    return triangles().area_vector(std::size_t(there.triangle)).normalized();
  }
  /// 1 outside, -1 inside where this is certain without a winding number: on the normal of the nearest triangle of a
  /// surface without a hole. 0 elsewhere.
  int side_of_face(SurfacePoint const& there, Vec<3, double> const& x) const {
    if (!report().encloses_exactly() || !(there.distance > front())) return 0;
    double const along = normal_of(there).dot(x - there.point);
    if (!(std::abs(along) > (1 - 1e-9) * there.distance)) return 0;
    return along > 0 ? 1 : -1;
  }
  /// Whether a point of a surface with holes is within another shell and so on no boundary.
  bool is_buried(SurfacePoint const& there) const {
    return !report().closed && there.distance < front() && is_enclosed(there.point + front() * normal_of(there));
  }

  std::shared_ptr<detail::MeshData const> data_;
};

class Mesh::Walk {
 public:
  explicit Walk(Mesh const& mesh) : mesh_(mesh) {}
  double operator()(Vec<3, double> const& x) {
    bool const is_first = there_.triangle < 0;
    SurfacePoint const last =
        std::exchange(there_, is_first ? mesh_.nearest(x) : mesh_.data_->tree.nearest(x, (x - there_.point).norm()));
    if (!mesh_.report().closed) return mesh_.signed_distance(there_, mesh_.is_inside(x, there_));
    double const apart = (x - x_).norm() + mesh_.front();  // no triangle is within two balls that meet
    if (is_first || !(apart < last.distance + there_.distance)) around_ = is_first ? number_at(x) : number_from_last(x);
    x_ = x;
    return mesh_.signed_distance(there_, around_ > 0);
  }

 private:
  long number_at(Vec<3, double> const& x) const {
    return mesh_.bounds().contains(x) ? std::lround(mesh_.winding_number(x)) : 0;
  }
  long number_from_last(Vec<3, double> const& x) const {
    if (int const side = mesh_.side_of_face(there_, x); side != 0) return side < 0;
    auto const entries = mesh_.data_->tree.entries(x_, x, mesh_.front());
    return entries ? around_ + *entries : number_at(x);
  }
  Mesh mesh_;
  Vec<3, double> x_ = Vec<3, double>::Zero();
  SurfacePoint there_;
  long around_ = 0;  // winding number of a closed surface
};
inline Mesh::Walk Mesh::walk() const { return Walk(*this); }

}  // namespace scree
