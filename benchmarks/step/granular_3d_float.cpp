// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "box.hpp"

namespace {

using namespace scree;
using namespace scree::bench;
[[maybe_unused]] int const rows =
    add_box_rows<GranularBox<3, float>>("granular") + add_box_rows<DefaultBox<3, float, ConservingWalls>>("default") +
    add_box_rows<DefaultBox<3, float, AdamiWalls>>("default_adami") +
    add_box_rows<DefaultBox<3, float, ConservingWalls, ObjectiveStrain>>("default_objective");

}  // namespace
