// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: several bodies have this role: name the one that is meant
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Vessel : scree::WallBody {
  static constexpr std::string_view name = "vessel";
};
struct Blade : scree::WallBody {
  static constexpr std::string_view name = "blade";
};
struct Flow : scree::Formulation<2> {
  using bodies = scree::Bodies<scree::Material, Vessel, Blade>;
  using physics = scree::Granular<>;
};
#ifdef FIXED
int count(scree::Solver<Flow> const& solver) { return solver.body<Blade>().size(); }
#else
int count(scree::Solver<Flow> const& solver) { return solver.wall().size(); }
#endif
