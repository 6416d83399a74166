// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tree.hpp"
#include "triangles.hpp"
#include "weld.hpp"
#include "winding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The boundary of the union of closed shells that touch, overlap or enclose each other. Each triangle is cut along the
// segments in which other triangles meet its plane. The winding numbers just in front of a piece and just behind it
// then show whether the piece separates the inside from the outside. Parts of the surface that are closer to each other
// than the tolerance are treated as one.
namespace scree::detail {

struct BoundaryOfUnion {
  Triangles triangles;
  double left_out = 0;              ///< area within another shell or between two, m^2
  std::string first_left_out = {};  ///< file and triangle; empty if every triangle is part of the boundary
  double inverted = 0;              ///< area of pieces in front of which the winding number is negative, m^2
  std::string first_inverted = {};  ///< file and triangle
};

class ShellUnion {
 public:
  /// Prepares the union; `behind` is the winding number just behind the middle of each triangle.
  ShellUnion(Triangles const& mesh, TriangleTree const& tree, WindingNumbers const& winding,
             std::vector<double> const& behind)
      : mesh_(mesh), tree_(tree), winding_(winding), behind_(behind), tolerance_(apart_at_least * tree.extent()) {}

  BoundaryOfUnion operator()() {
    result_.triangles = Triangles{.name = mesh_.name, .vertices = mesh_.vertices, .numbered = mesh_.numbered};
    for (std::size_t t = 0; t < mesh_.size(); ++t) take(t);
    drop_degenerate(result_.triangles);
    return std::move(result_);
  }

 private:
  using X = Vec<3, double>;
  using Piece = std::vector<X>;  // corners of a convex polygon, in the same direction as those of its triangle

  void take(std::size_t t) {
    corner_ = mesh_.vertex(t, 0), normal_ = mesh_.area_vector(t).normalized();
    pieces_.assign(1, Piece{mesh_.vertex(t, 0), mesh_.vertex(t, 1), mesh_.vertex(t, 2)});
    in_plane_.clear();
    Box<3> box{corner_, corner_};
    for (X const& x : pieces_[0]) box = hull(box, Box<3>{x, x});
    tree_.visit_box(grown(box, tolerance_), [&](int k) {
      if (tree_.place(k) != int(t)) cut_along(k);
      return true;
    });
    bool const is_apart = pieces_.size() == 1 && !lies_in_another(middle_of(pieces_[0]));
    std::vector<Piece const*> kept;
    double left_out = 0;
    for (Piece const& piece : pieces_) {
      if (is_apart ? std::abs(behind_[t] - 1) < 0.5 : is_boundary(t, piece))
        kept.push_back(&piece);
      else
        left_out += area_of(piece);
    }
    if (left_out == 0) {
      add(t, mesh_.corners[t]);
      return;
    }
    for (Piece const* piece : kept) add_fan(t, *piece);
    if (result_.first_left_out.empty()) result_.first_left_out = mesh_.place_of(t);
    result_.left_out += left_out;
  }
  void add(std::size_t t, std::array<int, 3> const& corners) {
    result_.triangles.corners.push_back(corners);
    result_.triangles.numbers.push_back(mesh_.number_of(t));
  }
  void add_fan(std::size_t t, Piece const& piece) {
    auto& vertices = result_.triangles.vertices;
    int const first = int(vertices.size()), count = int(piece.size());
    vertices.insert(vertices.end(), piece.begin(), piece.end());
    for (int k = 1; k + 1 < count; ++k) add(t, {first, first + k, first + k + 1});
  }

  /// Cuts the pieces along the part of another triangle that lies in their plane.
  void cut_along(int other) {
    Corners const& abc = tree_.corners(other);
    std::array<double, 3> const height{height_of(abc[0]), height_of(abc[1]), height_of(abc[2])};
    auto const [least, most] = std::minmax({height[0], height[1], height[2]});
    if (least > 0 || most < 0) return;
    if (least == 0 && most == 0) {
      in_plane_.push_back(other);
      for (std::size_t k = 0; k < 3; ++k) cut_all(abc[k], abc[(k + 1) % 3]);
      return;
    }
    std::array<X, 3> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t const next = (k + 1) % 3;
      if (height[k] == 0) ends[count++] = abc[k];
      if (height[k] * height[next] < 0) ends[count++] = crossing(abc[k], abc[next], height[k], height[next]);
    }
    if (count == 2) cut_all(ends[0], ends[1]);
  }
  double height_of(X const& x) const { return snapped(normal_.dot(X(x - corner_))); }
  void cut_all(X const& from, X const& to) {
    if (!((to - from).norm() > tolerance_)) return;
    if (pieces_.size() == 1 && is_corner(from) && is_corner(to)) return;
    for (std::size_t k = 0, count = pieces_.size(); k < count; ++k)
      if (auto other = cut(pieces_[k], from, to)) pieces_.push_back(std::move(*other));
  }
  /// Whether a point is a corner of the whole triangle.
  bool is_corner(X const& x) const {
    return std::any_of(pieces_[0].begin(), pieces_[0].end(), [&](X const& corner) { return corner == x; });
  }
  /// Cuts a piece along the line of a segment if the segment passes through the piece; returns the part left of the
  /// line.
  std::optional<Piece> cut(Piece& piece, X const& from, X const& to) const {
    X const along = (to - from).normalized(), left = normal_.cross(along);
    std::vector<double> side(piece.size());
    std::transform(piece.begin(), piece.end(), side.begin(),
                   [&](X const& x) { return snapped(left.dot(X(x - from))); });
    auto const [least, most] = std::minmax_element(side.begin(), side.end());
    if (!(*least < 0 && *most > 0)) return std::nullopt;
    std::array<Piece, 2> parts;
    std::vector<double> places;  // of the points on the line, along the segment, m
    auto const add_to_both = [&](X const& x) {
      for (Piece& part : parts) part.push_back(x);
      places.push_back(along.dot(X(x - from)));
    };
    for (std::size_t k = 0; k < piece.size(); ++k) {
      std::size_t const next = (k + 1) % piece.size();
      if (side[k] == 0)
        add_to_both(piece[k]);
      else
        parts[side[k] > 0].push_back(piece[k]);
      if (side[k] * side[next] < 0) add_to_both(crossing(piece[k], piece[next], side[k], side[next]));
    }
    auto const [enters, leaves] = std::minmax_element(places.begin(), places.end());
    if (!(std::min(*leaves, (to - from).norm()) - std::max(*enters, 0.0) > tolerance_)) return std::nullopt;
    piece = std::move(parts[0]);
    return std::move(parts[1]);
  }

  bool is_boundary(std::size_t t, Piece const& piece) {
    X const middle = middle_of(piece), depth = normal_ * (probe_depth * tree_.extent());
    if (pieces_.size() > 1 && area_of(piece) < 4 * tolerance_ * length_of(piece)) return false;  // too narrow to probe
    double const before = winding_(tree_, X(middle + depth), true);
    if (before < -0.5) {
      if (result_.inverted == 0) result_.first_inverted = mesh_.place_of(t);
      result_.inverted += area_of(piece);
    }
    if (!(winding_(tree_, X(middle - depth), true) > 0.5 && before < 0.5)) return false;
    return std::none_of(in_plane_.begin(), in_plane_.end(), [&](int k) {  // of coincident faces, the first is kept
      return tree_.place(k) < int(t) && turn_of(tree_.corners(k)) > 0 && is_over(tree_.corners(k), middle);
    });
  }
  bool lies_in_another(X const& x) const {
    return std::any_of(in_plane_.begin(), in_plane_.end(), [&](int k) { return is_over(tree_.corners(k), x); });
  }
  /// Returns twice the area of a triangle in the plane; negative if it faces the other way.
  double turn_of(Corners const& abc) const { return normal_.dot(X(abc[1] - abc[0]).cross(X(abc[2] - abc[0]))); }
  bool is_over(Corners const& abc, X const& x) const {
    double const way = turn_of(abc) > 0 ? 1 : -1;
    return std::min({turn_of({abc[0], abc[1], x}) * way, turn_of({abc[1], abc[2], x}) * way,
                     turn_of({abc[2], abc[0], x}) * way}) > 0;
  }

  double snapped(double distance) const { return std::abs(distance) <= tolerance_ ? 0 : distance; }
  static X crossing(X const& a, X const& b, double at_a, double at_b) { return a + (b - a) * (at_a / (at_a - at_b)); }
  static X middle_of(Piece const& piece) {
    X weighted = X::Zero();
    double total = 0;
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
      double const part = X(piece[k] - piece[0]).cross(X(piece[k + 1] - piece[0])).norm();
      weighted += part / 3 * (piece[0] + piece[k] + piece[k + 1]), total += part;
    }
    return total > 0 ? X(weighted / total) : piece[0];
  }
  static double area_of(Piece const& piece) {
    X twice = X::Zero();
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) twice += (piece[k] - piece[0]).cross(piece[k + 1] - piece[0]);
    return twice.norm() / 2;
  }
  static double length_of(Piece const& piece) {
    double longest = 0;
    for (X const& a : piece)
      for (X const& b : piece) longest = std::max(longest, (b - a).norm());
    return longest;
  }

  Triangles const& mesh_;
  TriangleTree const& tree_;
  WindingNumbers const& winding_;
  std::vector<double> const& behind_;
  double tolerance_;   // m
  X corner_, normal_;  // of the present triangle
  std::vector<Piece> pieces_;
  std::vector<int> in_plane_;  // other triangles in this plane, in the order of the tree
  BoundaryOfUnion result_;
};

}  // namespace scree::detail
