// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/io/csv_series.ipp>
#include <scree/io/point_columns.ipp>
#include <scree/run/progress.ipp>
#include <scree/setup/files/bytes_of.ipp>
#include <scree/setup/files/number_table.ipp>
#include <scree/setup/mesh/mesh.ipp>
#include <scree/setup/mesh/obj.ipp>
#include <scree/setup/mesh/read_mesh.ipp>
#include <scree/setup/mesh/read_polygon.ipp>
#include <scree/setup/mesh/stl.ipp>
#include <scree/setup/terrain/raster.ipp>
