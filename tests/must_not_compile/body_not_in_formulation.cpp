// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this body is not among the `bodies` of the formulation
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Blade : scree::WallBody {
  static constexpr std::string_view name = "blade";
};
struct Flow : scree::Formulation<2> {
#ifdef FIXED
  using bodies = scree::Bodies<scree::Material, Blade>;
#endif
  using physics = scree::Granular<>;
};
int particles_of_blade(scree::Solver<Flow> const& solver) { return solver.body<Blade>().size(); }
