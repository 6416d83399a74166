// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "inspect.hpp"
#include "mesh.hpp"
#include "unite.hpp"
#include "volume_below.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree {

namespace detail {

/// Computes the area of a mesh and, by the divergence theorem, its volume.
SCREE_BODY void measure(MeshReport& report, Triangles const& mesh) {
  Vec<3, double> const middle = (report.bounds.low + report.bounds.high) / 2;
  report.area = report.volume = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Vec<3, double> const area = mesh.area_vector(t);
    report.area += area.norm();
    report.volume += (mesh.vertex(t, 0) - middle).dot(area) / 3;
  }
}

/// Repairs the triangles where this is certain, and returns a report of what can be found without their tree.
SCREE_BODY MeshReport prepare(Triangles& mesh) {
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

/// A triangulated surface with its report, the tree of its triangles and their moments.
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
  /// Replaces the triangles by the boundary of the union of all shells.
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

SCREE_BODY Mesh::Mesh(Triangles triangles) : data_(std::make_shared<detail::MeshData const>(std::move(triangles))) {}

SCREE_BODY double Mesh::signed_distance(Vec<3, double> const& x) const {
  SurfacePoint const there = nearest(x);
  return signed_distance(there, is_inside(x, there));
}

SCREE_BODY bool Mesh::contains(Vec<3, double> const& x) const {
  if (!bounds().contains(x)) return false;
  return is_at_surface(x) ? signed_distance(x) < 0 : is_enclosed(x);
}

SCREE_BODY Vec<3, double> Mesh::outward_normal(Vec<3, double> const& x) const {
  SurfacePoint const there = nearest(x);
  Vec<3, double> const away = x - there.point;
  if (!(there.distance > 1e-6 * front())) return normal_of(there);
  return away * ((is_inside(x, there) ? -1 : 1) / there.distance);
}

SCREE_BODY SurfacePoint Mesh::nearest(Vec<3, double> const& x) const { return data_->tree.nearest(x); }

SCREE_BODY double Mesh::winding_number(Vec<3, double> const& x) const {
  return data_->winding(data_->tree, x, report().closed);
}

SCREE_BODY std::optional<double> Mesh::exact_volume_below(double level) const {
  if (!report().encloses_exactly()) return std::nullopt;
  return detail::volume_below(triangles(), level);
}

SCREE_BODY Triangles const& Mesh::triangles() const { return data_->triangles; }

SCREE_BODY MeshReport const& Mesh::report() const { return data_->report; }

SCREE_BODY double Mesh::signed_distance(SurfacePoint const& there, bool inside) const {
  if (!inside) return there.distance;
  return -(is_buried(there) ? std::max(there.distance, front()) : there.distance);
}

SCREE_BODY bool Mesh::is_inside(Vec<3, double> const& x, SurfacePoint const& there) const {
  int const side = side_of_face(there, x);
  return side != 0 ? side < 0 : is_enclosed(x);
}

SCREE_BODY bool Mesh::is_at_surface(Vec<3, double> const& x) const {
  Box<3> const around = detail::grown(Box<3>{x, x}, 1e-6 * front());
  return report().closed && !data_->tree.visit_box(around, [](int) { return false; });
}

SCREE_BODY bool Mesh::is_enclosed(Vec<3, double> const& x) const {
  return bounds().contains(x) && winding_number(x) > 0.5;
}

SCREE_BODY Vec<3, double> Mesh::normal_of(SurfacePoint const& there) const {
  return triangles().area_vector(std::size_t(there.triangle)).normalized();
}

SCREE_BODY int Mesh::side_of_face(SurfacePoint const& there, Vec<3, double> const& x) const {
  if (!report().encloses_exactly() || !(there.distance > front())) return 0;
  double const along = normal_of(there).dot(x - there.point);
  if (!(std::abs(along) > (1 - 1e-9) * there.distance)) return 0;
  return along > 0 ? 1 : -1;
}

SCREE_BODY bool Mesh::is_buried(SurfacePoint const& there) const {
  return !report().closed && there.distance < front() && is_enclosed(there.point + front() * normal_of(there));
}

SCREE_BODY double Mesh::Walk::operator()(Vec<3, double> const& x) {
  bool const is_first = there_.triangle < 0;
  SurfacePoint const last =
      std::exchange(there_, is_first ? mesh_.nearest(x) : mesh_.data_->tree.nearest(x, (x - there_.point).norm()));
  if (!mesh_.report().closed) return mesh_.signed_distance(there_, mesh_.is_inside(x, there_));
  double const apart = (x - x_).norm() + mesh_.front();  // no triangle is within two balls that meet
  if (is_first || !(apart < last.distance + there_.distance)) around_ = is_first ? number_at(x) : number_from_last(x);
  x_ = x;
  return mesh_.signed_distance(there_, around_ > 0);
}

SCREE_BODY long Mesh::Walk::number_at(Vec<3, double> const& x) const {
  return mesh_.bounds().contains(x) ? std::lround(mesh_.winding_number(x)) : 0;
}

SCREE_BODY long Mesh::Walk::number_from_last(Vec<3, double> const& x) const {
  if (int const side = mesh_.side_of_face(there_, x); side != 0) return side < 0;
  auto const entries = mesh_.data_->tree.entries(x_, x, mesh_.front());
  return entries ? around_ + *entries : number_at(x);
}

SCREE_BODY Mesh::Walk Mesh::walk() const { return Walk(*this); }

}  // namespace scree
