// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "box.hpp"

using scree::bench::SpeciesBox;
[[maybe_unused]] static int const three = scree::bench::add_box_rows<SpeciesBox<3, float, 3>>("three species");
[[maybe_unused]] static int const four = scree::bench::add_box_rows<SpeciesBox<3, float, 4>>("four species");
[[maybe_unused]] static int const eight = scree::bench::add_box_rows<SpeciesBox<3, float, 8>>("eight species");
