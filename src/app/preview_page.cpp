// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "preview_page.hpp"

#include "page_files.hpp"

#include <scree/app/json.hpp>
#include <scree/fields/bodies.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <string_view>

namespace scree::app {

namespace {

using Row = StartParticles::Row;

/// Number c of value i of an array.
double number(SnapshotArray const& array, std::size_t i, std::size_t c) {
  auto const* const at = array.bytes.data() + i * array.bytes_of_each() + c * size_of(array.element);
  auto const read = [&]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    return double(value);
  };
  if (array.element == ElementType::int32) return read(std::int32_t());
  return array.element == ElementType::float32 ? read(float()) : read(double());
}

/// The field with a number for each of N species.
constexpr std::string_view of_species = "concentrations";

/// How an array becomes one number for each particle.
enum class Shown { nothing, number, magnitude, pressure };
Shown how(std::string_view field, int components, int dimension) {
  for (auto const* const other : {"identity", "position", "rest position", "volume"})
    if (field == other) return Shown::nothing;
  if (field.starts_with("previous ") || field.starts_with("remainder of ")) return Shown::nothing;
  if (field == "stress" && components >= 3) return Shown::pressure;
  if (field == of_species) return Shown::number;  // one row for each
  if (components == 1) return Shown::number;
  return components == dimension ? Shown::magnitude : Shown::nothing;
}
double shown(SnapshotArray const& array, std::size_t i, Shown kind, std::size_t component) {
  if (kind == Shown::number) return number(array, i, component);
  if (kind == Shown::pressure)
    return -(number(array, i, 0) + number(array, i, 1) + number(array, i, 2)) / 3 + 0.0;  // no -0
  double squares = 0;
  for (std::size_t c = 0; c < std::size_t(array.components); ++c) squares += std::pow(number(array, i, c), 2);
  return std::sqrt(squares);
}

std::pair<double, double> range_of(std::vector<double> const& values, std::size_t count) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < count; ++i)
    if (std::isfinite(values[i])) low = std::min(low, values[i]), high = std::max(high, values[i]);
  return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
}
void find_ranges(Row& row, std::size_t of_material) {
  std::tie(row.low, row.high) = range_of(row.values, of_material > 0 ? of_material : row.values.size());
  std::tie(row.all_low, row.all_high) = range_of(row.values, row.values.size());
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string base64(std::vector<std::uint8_t> const& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::size_t const left = std::min<std::size_t>(bytes.size() - k, 3);
    std::uint32_t three = 0;
    for (std::size_t b = 0; b < 3; ++b) three = three << 8 | (b < left ? bytes[k + b] : 0U);
    for (std::size_t c = 0; c < 4; ++c) text += c <= left ? letters[three >> (18 - 6 * c) & 63] : '=';
  }
  return text;
}

/// Whole numbers of 16 bits over the ranges of the rows, first all low bytes, then all high ones.
std::string packed(std::vector<Row const*> const& rows, std::size_t stride) {
  constexpr double steps = 65535;
  std::vector<std::uint8_t> low, high;
  for (Row const* row : rows)
    for (std::size_t i = 0; i < row->values.size(); i += stride) {
      double const value = std::isfinite(row->values[i]) ? row->values[i] : row->all_low;
      double const width = row->all_high > row->all_low ? row->all_high - row->all_low : 1;
      auto const step = static_cast<unsigned>(std::lround((value - row->all_low) / width * steps));
      low.push_back(std::uint8_t(step & 255)), high.push_back(std::uint8_t(step >> 8));
    }
  low.insert(low.end(), high.begin(), high.end());
  return base64(low);
}

Json range(double low, double high) { return Json::Array{low, high > low ? high : low + 1}; }

std::string meta_of(AboutPage const& about, StartParticles const& particles, ReportOfStart const& report,
                    std::vector<Row const*> const& rows, std::size_t stride) {
  Json::Array ranges, scalars, bodies, lines;
  for (Row const* row : rows) ranges.push_back(range(row->all_low, row->all_high));
  for (Row const& row : particles.scalars)
    scalars.push_back(Json::Object{{"name", row.name}, {"unit", row.unit}, {"colours", range(row.low, row.high)}});
  for (auto const& body : particles.bodies) bodies.push_back(body.name);
  for (auto const& [name, text] : report) lines.push_back(Json::Array{name, text});
  std::size_t const count = (particles.body_of.size() + stride - 1) / stride;
  return to_json({{"title", about.title},
                  {"dimension", particles.dimension},
                  {"spacing", about.spacing * std::pow(double(stride), 1.0 / particles.dimension)},
                  {"times", Json::Array{particles.time}},
                  {"counts", Json::Array{count}},
                  {"continues", Json::Array{false}},
                  {"ranges", ranges},
                  {"stride", stride},
                  {"scalars", scalars},
                  {"bodies", bodies},
                  {"follows", true},
                  {"histories", Json::Array{}},
                  {"packing", "none"},
                  {"report", lines}});
}

}  // namespace

StartParticles::StartParticles(Snapshot const& snapshot) : time(snapshot.time) {
  std::vector<std::string> names;
  for (auto const& [key, value] : scree::detail::entries_of(snapshot.signature)) {
    if (key == "dimension") dimension = std::stoi(value);
    constexpr std::string_view end = " particles";
    if (!key.ends_with(end)) continue;
    auto const name = key.substr(0, key.size() - end.size());
    if (name != RigidStates::name) names.push_back(name);  // centres, not particles
  }
  // Fields of a body, and those of all bodies in the order in which they are shown.
  std::vector<std::string> fields = {"velocity", "stress", "concentration", std::string(of_species)};
  for (auto const& name : names) {
    auto const* const position = snapshot.find(name + "/position");
    std::size_t const count = position == nullptr ? 0 : position->count();
    if (count > 0 || bodies.empty()) bodies.push_back({name, count});
    if (count == 0) continue;
    for (auto const& array : snapshot.arrays)
      if (array.name.starts_with(name + "/") &&
          std::ranges::find(fields, array.name.substr(name.size() + 1)) == fields.end())
        fields.push_back(array.name.substr(name.size() + 1));
  }
  if (bodies.empty()) bodies.push_back({"material", 0});
  std::size_t const of_material = bodies.front().count;
  for (std::size_t b = 0; b < bodies.size(); ++b) body_of.insert(body_of.end(), bodies[b].count, double(b));

  for (int a = 0; a < dimension; ++a) {
    Row axis{.name = a == dimension - 1 ? "z" : a == 0 ? "x" : "y", .unit = "m"};
    for (auto const& body : bodies)
      for (std::size_t i = 0; i < body.count; ++i)
        axis.values.push_back(number(*snapshot.find(body.name + "/position"), i, std::size_t(a)));
    find_ranges(axis, of_material);
    axes.push_back(std::move(axis));
  }
  auto const add = [&](std::string const& field, std::size_t component, std::string const& name, bool always) {
    Row row;
    for (auto const& body : bodies) {
      auto const* const array = snapshot.find(body.name + "/" + field);
      auto const kind = array == nullptr ? Shown::nothing : how(field, array->components, dimension);
      if (kind != Shown::nothing) row.name = kind == Shown::pressure ? "pressure" : name, row.unit = array->unit;
      for (std::size_t i = 0; i < body.count; ++i)
        row.values.push_back(kind == Shown::nothing ? 0 : shown(*array, i, kind, component));
    }
    if (row.name.empty()) return;
    row.unit = replaced(row.unit, "dim", std::to_string(dimension));
    find_ranges(row, of_material);
    if ((always || row.all_high > row.all_low) && scalars.size() < most_scalars) scalars.push_back(std::move(row));
  };
  for (auto const& field : fields) {
    if (field == of_species) {
      auto const* const array = snapshot.find(bodies.front().name + "/" + field);
      for (int k = 0; array != nullptr && k < array->components; ++k)
        add(field, std::size_t(k), "concentration " + std::to_string(k + 1), false);
    } else {
      add(field, 0, field, field == "velocity" || field == "stress" || field == "concentration");
    }
  }
}

std::string page_of_start(AboutPage const& about, StartParticles const& particles, ReportOfStart const& report) {
  constexpr std::size_t most_particles = 300'000;
  std::size_t const stride = std::max<std::size_t>(1, (particles.body_of.size() + most_particles - 1) / most_particles);
  Row bodies{.name = "body", .values = particles.body_of};
  bodies.all_high = double(particles.bodies.size()) - 1;
  std::vector<Row const*> rows;
  for (Row const& axis : particles.axes) rows.push_back(&axis);
  rows.push_back(&bodies);
  for (Row const& scalar : particles.scalars) rows.push_back(&scalar);

  std::string scripts;
  for (auto const& script :
       {page_files::colours_js, page_files::axes_js, page_files::particles_js, page_files::page_js})
    scripts += script;
  std::string page(page_files::page_html);
  page = replaced(page, "@title@", replaced(replaced(about.title, "&", "&amp;"), "<", "&lt;"));
  page = replaced(page, "@scripts@", scripts);
  page = replaced(page, "@meta@", replaced(meta_of(about, particles, report, rows, stride), "</", "<\\/"));
  return replaced(page, "@data@", packed(rows, stride));
}

}  // namespace scree::app
