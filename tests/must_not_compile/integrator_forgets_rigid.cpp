// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this integrator does not advance rigid bodies
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Stone : scree::RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Explicit {
#ifdef FIXED
  static constexpr bool advances_rigid = true;
#endif
  template <class Evolved>
  using fields = scree::Merge<scree::evolved_fields<Evolved>, scree::rates_of_evolved<Evolved>>;
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    solver.update_rates();
    double const dt = solver.choose_step(longest);
#ifdef FIXED
    solver.advance_rigid({.kick = dt, .drift = dt});
#endif
    using Evolved = typename Solver::policy::physics::evolves;
    solver.update(scree::staggered_update<typename Solver::Basis>(Evolved{}, dt), 0, dt);
    return dt;
  }
};
struct Flow : scree::Formulation<2> {
  using bodies = scree::Bodies<scree::Material, scree::Wall, Stone>;
  using physics = scree::Granular<>;
  using integrator = Explicit;
};
void run(scree::Solver<Flow>& solver) { solver.run(1); }
