// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/system/system.hpp>

namespace scree::test {

/// A material and walls with given fields.
template <class P, class Search, class OfMaterial, class OfWall>
using TwoBodies = System<P, Search, PeriodicImages<P>, BodyWith<Material, OfMaterial>, BodyWith<Wall, OfWall>>;

}  // namespace scree::test
