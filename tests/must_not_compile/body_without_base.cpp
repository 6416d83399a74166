// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a body derives from MaterialBody, WallBody or RigidBody
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Soil
#ifdef FIXED
    : scree::MaterialBody
#endif
{
  static constexpr std::string_view name = "soil";
};
struct Other : Case {
  using bodies = scree::Bodies<Soil>;
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
