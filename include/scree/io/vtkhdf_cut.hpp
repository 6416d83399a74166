// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "vtkhdf_layout.hpp"

// Functions to continue a series: they find the last step in its file and remove steps that will be written again.
namespace scree::detail {

inline std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  auto const add = [](hid_t, char const* name, H5L_info_t const*, void* all) -> herr_t {
    static_cast<std::vector<std::string>*>(all)->emplace_back(name);
    return 0;
  };
  hdf5::check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names));
  return names;
}

inline std::int64_t number_of_steps(hid_t steps) {
  hdf5::Handle const attribute{hdf5::check(H5Aopen(steps, "NSteps", H5P_DEFAULT)), H5Aclose};
  std::int64_t number = 0;
  hdf5::check(H5Aread(attribute, H5T_NATIVE_INT64, &number));
  return number;
}

/// Returns the position after the last step whose time is at most `time`.
inline StepPosition position_after(hid_t root, double time) {
  hdf5::Handle const steps = hdf5::open_group(root, "Steps");
  StepPosition position;
  if (number_of_steps(steps) == 0) return position;
  auto const values = hdf5::read_rows<double>(steps, "Values");
  auto const in_order = values.begin() + std::min<std::ptrdiff_t>(number_of_steps(steps), std::ssize(values));
  // At most `time`, apart from rounding errors.
  auto const end =
      std::partition_point(values.begin(), in_order, [time](double value) { return value <= time * (1 + 1e-12); });
  if (end == values.begin()) return position;
  auto const last = static_cast<std::size_t>(end - values.begin()) - 1;
  position.index = last + 1;
  position.time = values[last];
  position.part = hdf5::read_rows<std::int64_t>(steps, "PartOffsets").at(last);
  position.part_size = hdf5::read_rows<std::int64_t>(root, "NumberOfPoints").at(std::size_t(position.part));
  position.point = hdf5::read_rows<std::int64_t>(steps, "PointOffsets").at(last) + position.part_size;
  position.cell = hdf5::read_rows<std::int64_t>(steps, "CellOffsets").at(4 * last);
  return position;
}

inline void cut_tables(hid_t group, std::int64_t rows) {
  for (auto const& name : names_in(group)) {
    hdf5::Handle const object{hdf5::check(H5Oopen(group, name.c_str(), H5P_DEFAULT)), H5Oclose};
    if (H5Iget_type(object) == H5I_DATASET) hdf5::cut_rows(object, static_cast<hsize_t>(rows));
  }
}

/// Removes all steps after `time` and returns the position of the next step. Vertices of removed steps may remain,
/// unused.
inline StepPosition cut_after(hid_t file, double time) {
  hdf5::Handle const root = hdf5::open_group(file, "VTKHDF");
  StepPosition const position = position_after(root, time);
  hdf5::Handle const steps = hdf5::open_group(root, "Steps");
  if (static_cast<std::int64_t>(position.index) == number_of_steps(steps)) return position;
  write_number_of_steps(steps, position.index);
  auto const index = static_cast<std::int64_t>(position.index);
  cut_tables(steps, index);
  cut_tables(hdf5::open_group(steps, "PointDataOffsets"), index);
  cut_tables(hdf5::open_group(root, "PointData"), position.point);
  hdf5::Handle const points{hdf5::check(H5Dopen2(root, "Points", H5P_DEFAULT)), H5Dclose};
  hdf5::cut_rows(points, static_cast<hsize_t>(position.point));
  return position;
}

}  // namespace scree::detail
