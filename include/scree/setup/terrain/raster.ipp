// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/available_memory.hpp"
#include "../../core/compiled.hpp"
#include "../files/bytes_of.hpp"
#include "../files/text_reader.hpp"
#include "raster.hpp"

#include <cctype>

namespace scree {

namespace detail {

SCREE_BODY bool is_usual_mark(double value) {
  for (double const mark : {-9999.0, -99999.0, -32768.0, -32767.0, 32767.0})
    if (value == mark) return true;
  return false;
}
SCREE_BODY std::string not_a_height(double value) {
  if (!(std::abs(value) <= highest)) return "is no height or depth: these are within " + short_text(highest) + " m";
  return is_usual_mark(value) ? "is a usual mark of points without a value" : "";
}

SCREE_BODY void check_metres(Raster const& raster) {
  double const seconds = 3600 * raster.spacing, ninths = 9 * seconds, in_steps = raster.spacing * 1e5;
  bool const is_arc = raster.spacing < 0.1 && std::abs(in_steps - std::round(in_steps)) > 1e-3 &&
                      std::abs(ninths - std::round(ninths)) < 1e-4 * ninths;
  double low = highest, high = -highest;
  for (double const value : raster.values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  bool const is_steep =
      raster.spacing < 0.1 && high - low > 100 * raster.spacing * std::max(raster.columns, raster.rows);
  if (is_arc || is_steep)
    throw std::runtime_error(formatted(
        "%s: the cellsize of %.9g looks like degrees, with values from %g to %g m: a raster in metres is needed, "
        "gdalwarp -t_srs makes one",
        raster.name.c_str(), raster.spacing, low, high));
}

SCREE_BODY void check_marks(Raster const& raster) {
  for (double const mark : {-999.0, 9999.0, 65535.0, 99999.0}) {
    std::size_t const none = raster.values.size();
    std::size_t first = none;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < raster.values.size(); ++k)
      if (raster.values[k] == mark)
        first = std::min(first, k);
      else if (!std::isnan(raster.values[k]))
        nearest = std::min(nearest, std::abs(raster.values[k] - mark));
    if (first == none || nearest <= 100 || std::isinf(nearest)) continue;
    auto const columns = static_cast<std::size_t>(raster.columns);
    throw std::runtime_error(formatted(
        "%s: %g at x = %.9g, y = %.9g m is a usual mark of points without a value, and no other value is "
        "within 100 m of it: declare it as NODATA_value, or write %g.01 if it is a height",
        raster.name.c_str(), mark, raster.x_of(int(first % columns)), raster.y_of(int(first / columns)), mark));
  }
}

/// The head of an ESRI ASCII grid: names, in upper or lower case, with numbers, in any order, each once.
struct GridHead {
  double ncols = 0, nrows = 0, x = 0, y = 0, cellsize = 0, nodata = -9999;
  bool has_x = false, has_y = false, x_of_centre = false, y_of_centre = false;
  std::vector<std::string> taken = {};  // names, without "corner" and "center"

  /// Reads a line of the head; returns false if the line is not part of the head.
  bool take(TextReader const& reader) {
    std::string name(reader.word(0));
    if (!std::isalpha(static_cast<unsigned char>(name[0])) || name.size() > 12) return false;
    for (char& c : name) c = char(std::tolower(static_cast<unsigned char>(c)));
    if (name == "nan" || name == "inf" || name == "infinity") return false;
    reader.demand(reader.words().size() == 2, "a line of the head is a name and a number");
    std::string const what = name.substr(0, name.starts_with("xll") || name.starts_with("yll") ? 3 : name.npos);
    if (std::find(taken.begin(), taken.end(), what) != taken.end())
      reader.fail("'" + std::string(reader.word(0)) + "' repeats a line of the head, or contradicts it");
    taken.push_back(what);
    double const value = reader.number(1);
    if (name == "ncols") return ncols = value, true;
    if (name == "nrows") return nrows = value, true;
    if (name == "cellsize") return cellsize = value, true;
    if (name == "nodata_value") return nodata = value, true;
    bool const centre = name.ends_with("center");
    if (name == "xllcorner" || name == "xllcenter") return x = value, has_x = true, x_of_centre = centre, true;
    if (name == "yllcorner" || name == "yllcenter") return y = value, has_y = true, y_of_centre = centre, true;
    reader.fail("'" + std::string(reader.word(0)) +
                "' is not in the head of an ESRI ASCII grid; dx and dy are not read");
  }
  void check(TextReader const& reader) const {
    auto const is_count = [](double n) { return n >= 2 && n <= most_particles && n == std::floor(n); };
    reader.demand(is_count(ncols) && is_count(nrows), "the head needs ncols and nrows, whole numbers of 2 or more");
    reader.demand(cellsize > 0, "the head needs a cellsize above 0");
    reader.demand(cellsize >= 1e-6 && cellsize <= 1e6, "the cellsize must be 1e-6 to 1e6 m");
    reader.demand(has_x && has_y, "the head needs xllcorner or xllcenter, and yllcorner or yllcenter");
    reader.demand(std::abs(x) <= 1e9 && std::abs(y) <= 1e9, "the coordinates of the corner must be within 1e9 m");
  }
};

}  // namespace detail

SCREE_BODY Raster read_asc(std::string_view text, std::string const& name) {
  detail::TextReader reader(text, name);
  detail::GridHead head;
  bool more = reader.next();
  while (more && head.take(reader)) more = reader.next();
  head.check(reader);
  double const half = head.cellsize / 2;
  Raster result{name,
                int(head.ncols),
                int(head.nrows),
                head.x + (head.x_of_centre ? 0 : half),
                head.y + (head.y_of_centre ? 0 : half),
                head.cellsize};
  double const count = head.ncols * head.nrows;
  reader.demand(count <= double(text.size()), "the head names more values than the file has");
  reader.demand(count <= most_particles, "there are more values than can be counted");
  result.values.reserve(static_cast<std::size_t>(count));
  for (; more; more = reader.next())
    for (std::size_t k = 0; k < reader.words().size(); ++k) {
      reader.demand(double(result.values.size()) < count, "there are more values than the head names");
      bool const is_nan = reader.word(k) == "nan" || reader.word(k) == "NaN" || reader.word(k) == "-nan";
      double const value = is_nan ? head.nodata : reader.number(k);
      bool const is_missing = is_nan || value == head.nodata;
      if (std::string const why = is_missing ? "" : detail::not_a_height(value); !why.empty())
        reader.fail("'" + std::string(reader.word(k).substr(0, 40)) + "' " + why +
                    "; the NODATA_value of the head is " + detail::formatted("%.9g", head.nodata));
      result.values.push_back(is_missing ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  if (double(result.values.size()) != count)
    reader.fail("the file ends after " + std::to_string(result.values.size()) + " of " + detail::short_text(count) +
                " values");
  for (int low = 0, high = result.rows - 1; low < high; ++low, --high) {
    auto const row = [&](int k) { return result.values.begin() + std::ptrdiff_t(k) * result.columns; };
    std::swap_ranges(row(low), row(low + 1), row(high));
  }
  detail::check_marks(result);
  detail::check_metres(result);
  return result;
}

SCREE_BODY Raster read_raster(std::filesystem::path const& file) {
  std::string const bytes = detail::bytes_of(file);
  if (bytes.starts_with(std::string_view("II*\0", 4)) || bytes.starts_with(std::string_view("MM\0*", 4)))
    throw std::runtime_error(file.string() +
                             ": it is a GeoTIFF: read it with read_gdal() of scree::gdal, or convert it, " +
                             "gdal_translate -of AAIGrid dem.tif dem.asc");
  return read_asc(bytes, file.filename().string());
}

}  // namespace scree
