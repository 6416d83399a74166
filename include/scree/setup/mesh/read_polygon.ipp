// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "../files/bytes_of.hpp"
#include "obj_lines.hpp"
#include "read_polygon.hpp"

#include <map>

namespace scree {

namespace detail {

/// Pieces of lines, each with its line in the file. Each vertex joins two pieces.
class LineJoiner {
 public:
  explicit LineJoiner(std::string name) : name_(std::move(name)) {}
  void add(int from, int to, int line) {
    if (from == to) return;
    ends_[from].push_back({to, line});
    ends_[to].push_back({from, line});
  }
  /// Returns the vertices of each closed line. Throws std::runtime_error if a vertex does not join exactly two pieces.
  std::vector<std::vector<int>> loops() {
    for (auto const& [vertex, ends] : ends_)
      if (ends.size() != 2)
        throw std::runtime_error(
            formatted("%s, line %d: vertex %d is the end of %zu pieces of lines; closed polygons have two",
                      name_.c_str(), ends[0].line, vertex + 1, ends.size()));
    std::vector<std::vector<int>> result;
    while (!ends_.empty()) {
      std::vector<int> loop;
      for (int at = ends_.begin()->first, before = -1; ends_.contains(at);) {
        auto const ends = ends_[at];
        ends_.erase(at);
        loop.push_back(at);
        int const next = ends[0].to == before ? ends[1].to : ends[0].to;
        before = at, at = next;
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  struct End {
    int to, line;
  };
  std::string name_;
  std::map<int, std::vector<End>> ends_;
};

/// Returns the coordinates of points in their plane: x and y if all z are equal, x and z if all y are equal.
SCREE_BODY std::vector<Vec<2, double>> in_coordinate_plane(std::vector<Vec<3, double>> const& points,
                                                           std::string const& name) {
  auto const is_flat = [&](int axis) {
    return std::all_of(points.begin(), points.end(), [&](auto const& x) { return x[axis] == points[0][axis]; });
  };
  if (!is_flat(1) && !is_flat(2))
    throw std::runtime_error(name + ": the vertices of a polygon in the plane have one y or one z, all of them");
  std::vector<Vec<2, double>> result;
  int const up = is_flat(2) ? 1 : 2;
  for (auto const& x : points) result.push_back({x[0], x[up]});
  return result;
}

}  // namespace detail

SCREE_BODY Polygon polygon_from_obj(std::string_view text, std::string const& name, PlanePlacement const& placement) {
  check_setting(placement.scale > 0 && std::isfinite(placement.scale), "scale of a polygon", placement.scale,
                "above 0");
  detail::LineJoiner lines(name), outlines(name);
  bool has_lines = false;
  auto const vertices = detail::read_obj_lines(text, name, [&](detail::TextReader const& reader, auto const& so_far) {
    bool const is_line = reader.word(0) == "l";
    if (!is_line && reader.word(0) != "f") return;
    auto const places = detail::obj_vertices(reader, so_far.size());
    for (std::size_t k = 1; k < places.size(); ++k)
      (is_line ? lines : outlines).add(places[k - 1], places[k], reader.line());
    if (!is_line && !places.empty()) outlines.add(places.back(), places.front(), reader.line());
    has_lines = has_lines || is_line;
  });
  std::vector<Polygon::Loop> loops;
  for (auto const& loop : (has_lines ? lines : outlines).loops()) {
    std::vector<Vec<3, double>> points;
    for (int const place : loop) points.push_back(vertices[std::size_t(place)]);
    loops.emplace_back();
    for (auto const& x : detail::in_coordinate_plane(points, name)) loops.back().push_back(placement(x));
  }
  try {
    return Polygon(loops);
  } catch (std::invalid_argument const& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

SCREE_BODY Polygon read_polygon(std::filesystem::path const& file, PlanePlacement const& placement) {
  return polygon_from_obj(detail::bytes_of(file), file.filename().string(), placement);
}

}  // namespace scree
