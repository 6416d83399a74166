// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `bodies` of this formulation needs exactly one body that derives from MaterialBody
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Clay : scree::MaterialBody {
  static constexpr std::string_view name = "clay";
};
#ifdef FIXED
struct Cover : scree::WallBody {
#else
struct Cover : scree::MaterialBody {
#endif
  static constexpr std::string_view name = "cover";
};
struct Layers : scree::Formulation<2> {
  using bodies = scree::Bodies<Clay, Cover>;
  using physics = scree::Granular<>;
};
using Advanced = scree::Solver<Layers>;
double advance(Advanced& solver) { return solver.step(1); }
