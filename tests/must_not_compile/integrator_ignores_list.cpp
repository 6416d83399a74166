// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the function of an integrator updates other fields than those of the list that it gets
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Stone : scree::RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Explicit {
  template <class Evolved>
  using fields = scree::Merge<scree::evolved_fields<Evolved>, scree::rates_of_evolved<Evolved>>;
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    solver.update_rates();
    double const dt = solver.choose_step(longest);
    using P = typename Solver::Basis;
#ifdef FIXED
    solver.update([dt](auto evolved) { return scree::staggered_update<P>(evolved, dt); }, 0, dt);
#else
    using Evolved = typename Solver::policy::physics::evolves;
    solver.update([dt](auto) { return scree::staggered_update<P>(Evolved{}, dt); }, 0, dt);
#endif
    return dt;
  }
};
struct Flow : scree::Formulation<2> {
  using bodies = scree::Bodies<scree::Material, scree::Wall, Stone>;
  using physics = scree::Granular<>;
  using integrator = Explicit;
};
void run(scree::Solver<Flow>& solver) { solver.run(1); }
