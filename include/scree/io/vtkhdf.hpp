// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "disk_space.hpp"
#include "point_data.hpp"
#include "twin_file.hpp"
#include "vtkhdf_cut.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace scree {

namespace detail {

/// Creates a file, or checks that an existing one is a writable regular file.
inline void create_or_keep(std::filesystem::path const& path, bool may_exist) {
  if (may_exist && std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    throw hdf5::Failure("it is not a regular file");
  }
  std::FILE* const file = std::fopen(path.c_str(), may_exist ? "ab" : "abx");
  if (file == nullptr && errno == EEXIST) throw hdf5::Failure("it exists; remove it, or give the option overwrite");
  if (file == nullptr) throw std::system_error(errno, std::generic_category());
  std::fclose(file);
}

}  // namespace detail

/// A time series of particles in one VTKHDF file (PolyData, one vertex per particle). ParaView >= 5.12 and VTK >= 9.3
/// open the file with its times.
///
///     VtkHdfSeries series("out/particles.vtkhdf", {.provenance = {{"case", text}}});
///     series.append(t, xyz, {{.name = "concentration", .values = c}, {.name = "normal", .components = 3, .values =
///     n}});
///
/// The file is complete at any time: it can be opened during a run, and if the run stops or is killed while it writes,
/// the file contains all steps appended so far. Steps are therefore also written to a copy, "FILE.part", so a series
/// needs twice the disk space until it is destroyed. Vertices are written only when the number of particles changes;
/// otherwise, steps share them. File errors throw std::runtime_error with the file, the failed action and the cause.
/// Before it writes, append() reserves disk space, so that existing steps survive a full disk. Invalid arguments throw
/// std::invalid_argument and leave the file unchanged. Writes nothing on ranks other than the first
/// (core/writes_files.hpp); there, steps() is the number of steps appended.
class VtkHdfSeries {
 public:
  /// Creates the file without steps. Its directory must exist; the file must not exist, unless options.overwrite is
  /// set.
  explicit VtkHdfSeries(std::filesystem::path path, VtkHdfOptions options = {})
      : file_(std::move(path)), options_(std::move(options)) {
    if (writes_) attempt(file_.file(), "create it", [&] { create(); });
  }
  /// Returns a series that continues after a restart: the file at `path` is replaced by a copy of `from` (which may be
  /// the same file) without the steps after `time` (s). Throws std::runtime_error if `from` cannot be read or contains
  /// no such series.
  static VtkHdfSeries continued(std::filesystem::path const& from, double time, std::filesystem::path path,
                                VtkHdfOptions options = {}) {
    return {from, time, std::move(path), std::move(options)};
  }

  /// Throws the std::runtime_error that continued() would throw because of the content of the file.
  static void check(std::filesystem::path const& path) {
    attempt(path, "read it", [&] {
      hdf5::Handle const file = open(path, H5F_ACC_RDONLY);
      detail::position_after(hdf5::open_group(file, "VTKHDF"), std::numeric_limits<double>::infinity());
    });
  }

  /// Appends the step at `time`, which must be later than the last step (in any unit, the same for all steps). `xyz`
  /// holds 3 n coordinates, particle by particle (in 2D, with a constant third coordinate). Each of the `fields` has n
  /// * components values; their names, components and number types must be the same, in the same order, at every step.
  /// Numbers are stored in the precision of the first step.
  void append(double time, PointCoordinates const& xyz, std::span<PointField const> fields) {
    check_arguments(time, xyz, fields);
    if (!writes_) {
      columns_ = detail::columns_of(fields), step_.time = time, ++step_.index;
      return;
    }
    attempt(path(), fmt::format("append step {} (time {})", step_.index, time), [&] {
      std::size_t const n = detail::size_of(xyz) / 3;
      if (step_.index == 0) chunk_rows_ = detail::chunk_rows(n);
      detail::StepPosition next;
      file_.change([&](std::filesystem::path const& copy) {
        reserve_disk_space(copy, detail::bytes_of_rows(n + chunk_rows_, fields));
        next = write_step(copy, time, xyz, fields);
      });
      columns_ = detail::columns_of(fields);
      names_.clear();
      step_ = next;
    });
  }
  void append(double time, PointCoordinates const& xyz, std::initializer_list<PointField> fields) {
    append(time, xyz, std::span<PointField const>(fields.begin(), fields.size()));
  }
  void append(PointData const& data) {
    std::vector<PointField> fields;
    for (PointArray const& array : data.arrays)
      std::visit(
          [&](auto const& values) {
            fields.push_back({array.name, array.components, std::span(values), array.unit});
          },
          array.values);
    std::visit([&](auto const& xyz) { append(data.time, std::span(xyz), fields); }, data.xyz);
  }

  /// Returns the number of steps in the file.
  std::size_t steps() const { return step_.index; }
  /// Returns the path of the file.
  std::filesystem::path const& path() const { return file_.file(); }

 private:
  VtkHdfSeries(std::filesystem::path const& from, double time, std::filesystem::path path, VtkHdfOptions options)
      : file_(std::move(path)), options_(std::move(options)) {
    if (!writes_) return;
    attempt(file_.file(), fmt::format("continue {}", from.string()), [&] {
      file_.begin_from(from, [&](std::filesystem::path const& copy) {
        hdf5::Handle file = open(copy);
        step_ = detail::cut_after(file, time);
        if (step_.index > 0) names_ = detail::names_in(hdf5::open_group(file, "VTKHDF/PointData"));
        hdf5::check(file.close());
      });
    });
    chunk_rows_ = detail::chunk_rows(static_cast<std::size_t>(step_.part_size));
  }

  template <class Action>
  static void attempt(std::filesystem::path const& path, std::string const& what, Action action) {
    hdf5::Silence const silence;
    std::string cause;
    try {
      return action();
    } catch (hdf5::Failure const& failure) {
      cause = failure.what();
    } catch (std::system_error const& failure) {
      cause = failure.code().message();
    } catch (std::out_of_range const&) {
      cause = "a table in it is shorter than it should be";
    }
    throw std::runtime_error(fmt::format("{}: cannot {}: {}", path.string(), what, cause));
  }

  void create() const {
    bool const is_new = !std::filesystem::exists(path());
    detail::create_or_keep(path(), options_.overwrite);
    try {
      reserve_disk_space(path(), detail::bytes_of_empty_series);
    } catch (...) {
      if (is_new) std::filesystem::remove(path());
      throw;
    }
    hdf5::Handle const access = hdf5::without_locks();
    hdf5::Handle file{hdf5::check(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)), H5Fclose};
    detail::create_groups(file);
    hdf5::Handle own = hdf5::create_group(file, "scree");
    for (auto const& [name, text] : options_.provenance) detail::write_provenance(own, name, text);
    hdf5::check(own.close());
    hdf5::check(file.close());
  }

  static hdf5::Handle open(std::filesystem::path const& path, unsigned flags = H5F_ACC_RDWR) {
    hdf5::Handle const access = hdf5::without_locks();
    return {hdf5::check(H5Fopen(path.c_str(), flags, access)), H5Fclose};
  }

  /// Writes a step and returns the position of the next one.
  detail::StepPosition write_step(std::filesystem::path const& path, double time, PointCoordinates const& xyz,
                                  std::span<PointField const> fields) const {
    detail::StepPosition next = step_;
    next.time = time;
    auto const n = static_cast<std::int64_t>(detail::size_of(xyz) / 3);
    hdf5::Handle file = open(path);
    {
      hdf5::Handle const root = hdf5::open_group(file, "VTKHDF");
      if (next.index == 0) {
        bool const is_double = std::holds_alternative<std::span<double const>>(xyz);
        hid_t const real = detail::stored_real(is_double, options_.single_precision);
        detail::create_tables(root, fields, {.chunk_rows = chunk_rows_, .real = real, .options = &options_});
      }
      if (next.index == 0 || n != next.part_size) {
        next.begin_part(n);
        detail::write_part(root, next);
      }
      detail::write_particles(root, next.point, xyz, fields);
      detail::write_step_entry(root, next, fields);
    }
    hdf5::check(file.close());
    next.point += n;
    ++next.index;
    return next;
  }

  void check_arguments(double time, PointCoordinates const& xyz, std::span<PointField const> fields) const {
    auto const refuse = [&](std::string const& why) {
      throw std::invalid_argument(fmt::format("{}: cannot append step {}: {}", path().string(), step_.index, why));
    };
    if (!std::isfinite(time)) refuse(fmt::format("its time is {}", time));
    if (step_.index > 0 && !(time > step_.time)) {
      refuse(fmt::format("its time {} is not after the last step's {}", time, step_.time));
    }
    std::size_t const size = detail::size_of(xyz);
    if (size % 3 != 0) refuse(fmt::format("{} coordinates are not three for each particle", size));
    if (auto const wrong = detail::fault_of(fields, size / 3); !wrong.empty()) refuse(wrong);
    bool const same = names_.empty() ? detail::columns_of(fields) == columns_ : detail::names_of(fields) == names_;
    if (step_.index > 0 && !same) refuse("its fields are not those of the first step");
  }

  bool const writes_ = writes_files();
  TwinFile file_;
  VtkHdfOptions options_;
  detail::StepPosition step_;
  std::vector<detail::FieldLayout> columns_;
  std::vector<std::string> names_;  // names of fields of a continued series, until its next step
  std::size_t chunk_rows_ = 0;
};

}  // namespace scree
