// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "box.hpp"

using Box3D = scree::bench::SegregatingBox<3, float>;
[[maybe_unused]] static int const rows = scree::bench::add_box_rows<Box3D>("segregating");
[[maybe_unused]] static int const list_free_rows =
    scree::bench::add_box_rows<scree::bench::ListFree<Box3D>>("segregating_list_free");
