// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/formulation/formulation.hpp>
#include "point_function.hpp"

namespace scree::test::archetypes {

struct Output {
  auto passes(Resolution const&) const { return std::tuple(point_pass<Material>("double", PointFunctionOfOne{})); }
};
static_assert(DiagnosticPasses<Output, int>);

}  // namespace scree::test::archetypes
