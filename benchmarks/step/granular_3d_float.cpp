// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "box.hpp"

[[maybe_unused]] static int const rows = scree::bench::add_box_rows<scree::bench::GranularBox<3, float>>("granular");
