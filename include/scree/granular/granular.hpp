// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/tuple.hpp"
#include "../laws/plausible.hpp"
#include "../laws/relative_density.hpp"
#include "../laws/response.hpp"
#include "../laws/strength.hpp"
#include "../laws/well_posedness.hpp"
#include "../passes/limit.hpp"
#include "../passes/mixture_bound.hpp"
#include "../passes/resolution.hpp"
#include "../passes/stage.hpp"
#include "../terms/carried_momentum.hpp"
#include "../terms/stress_divergence.hpp"
#include "../terms/wall_force.hpp"
#include "beside_cone.hpp"
#include "explain.hpp"
#include "forces.hpp"
#include "forces_of_strain.hpp"
#include "models.hpp"
#include "return_stress.hpp"
#include "rigid_rotation.hpp"
#include "several_materials.hpp"
#include "validity.hpp"
#include "viscous_share.hpp"

#include <limits>
#include <string>
#include <vector>

namespace scree {

/// Physics model with the momentum balance and the constitutive law of a dry granular material between walls (Zhu et
/// al. 2024, sections 2 and 3). The density of a particle is constant. It differs between groups if the law is ByGroup,
/// and it follows the composition of the particle if the law is MixtureDensity.
template <class Models = GranularModels>
struct Granular {
  using Law = typename Models::law;
  using Filter = typename Models::filter;
  using Volume = granular::volume_control_of<typename Models::volume_control, Law>;
  using Walls = typename Models::walls;
  using EvolvedLaw = granular::evolved_law<Law, Volume>;
  /// The section of the yield surface in `dim` dimensions.
  template <int dim>
  using section_in = granular::section_of<typename Models::section, Law, dim>;

  Law law = {};
  Gravity gravity = {};
  double viscosity_speed = 0.5;
  double cfl = 0.2;
  Filter filter = {};
  Volume volume_control = {};
  Walls walls = {};
  typename Models::forces forces = {};
  typename Models::advection advection = {};
  typename Models::viscosity viscosity = {};
  double largest_mach = 1;            ///< infinite: no bound
  double largest_number_density = 2;  ///< infinite: no bound

  using evolves = Merge<Fields<typename Models::advection::position, Velocity, Stress>, typename EvolvedLaw::history,
                        typename Filter::history>;

  /// Returns two or more stages: the first evolves the stress from positions and velocities; the following stages
  /// evolve velocities and positions from the new stress.
  auto stages(Resolution const& resolution) const {
    auto const rates = pair_pass_then<Material>("scree::strain_rates", strain(resolution),
                                                strain_over<Material>(AsIs{}, VelocityGradientSum{}), wall_strain());
    using Admit = granular::Admit<EvolvedLaw, typename Models::section, typename Filter::history>;
    auto const admit = point_pass<Material>("scree::admit", Admit{evolved_law()});
    auto const accelerate =
        pair_pass_then<Material>("scree::acceleration", granular::Motion<MotionForces>{gravity, motion_forces()},
                                 motion_over<Material>(AsIs{}, resolution), motion_over<Wall>(wall_lens(), resolution));
    using Evolved = Merge<Fields<Stress>, typename EvolvedLaw::history, typename Filter::history>;
    // The density of a mixture follows the exchange of grains, which takes place between the stages. Other densities
    // that differ between particles, like those of ByGroup, are computed in the first stage, because particles of other
    // bodies read them in the second stage.
    constexpr bool of_mixture = DensityOfMixture<Law>;
    return std::tuple_cat(
        std::tuple(stage<Evolved>(
            detail::in_a_row(density_passes_if<!of_mixture>(), ForcesOfStrain{}.passes_if(resolution.afresh),
                             walls.velocity_passes(), detail::Tuple(rates)),
            detail::in_a_row(detail::Tuple(admit), ForcesOfStrain{}.projections()))),
        advection.stages(rho(), detail::in_a_row(density_passes_if<of_mixture>(), force_passes(resolution),
                                                 walls.stress_passes(rho(), gravity), detail::Tuple(accelerate))));
  }
  /// Returns the densities of the species (kg/m^3) of a law whose density follows the mixture.
  auto species_densities() const requires DensityOfMixture<Law> { return law.densities; }
  /// Returns the terms for pairs of a particle of this material and a particle of another material in another body, for
  /// PhysicsOfBodies. Both bodies share one velocity field, as if they were bonded: the strain of each body depends on
  /// the velocities of both, and the stress divergence has the form for two densities, so that momentum and energy are
  /// conserved. The artificial viscosity is PlainViscosity with the mean of both values of `viscosity_speed`. The
  /// `forces` of the models act within each body only.
  template <class OtherModels>
  auto interface_terms(Granular<OtherModels> const& other, Resolution const&) const {
    static_assert(!DensityOfMixture<Law> && !DensityOfMixture<typename OtherModels::law>,
                  "species with densities of their own can only be in a case with one body that evolves");
    static_assert(granular::IsObjective<typename Models::strain> == granular::IsObjective<typename OtherModels::strain>,
                  "two bodies that evolve have ObjectiveStrain both or neither: each feels the antisymmetric stress of "
                  "the other");
    auto const of_stress = InterfaceStressDivergence<decltype(rho())>{rho()};
    auto const of_viscosity = InterfaceViscosity<decltype(rho()), decltype(other.rho())>{
        rho(), other.rho(), (viscosity_speed + other.viscosity_speed) / 2};
    auto const of_motion =
        std::tuple_cat(std::tuple(of_stress, of_viscosity), ForcesOfStrain{}.template terms<Material>(rho()));
    if constexpr (Volume::active)
      return std::tuple_cat(std::tuple(VelocityGradientSum{}, FirstMomentSum{}, NumberDensitySum{}), of_motion);
    else
      return std::tuple_cat(std::tuple(VelocityGradientSum{}, FirstMomentSum{}), of_motion);
  }
  /// Returns the passes of the stress filter.
  auto filters(Resolution const&) const {
    constexpr bool changes_stress = detail::tuple_size < decltype(filter.passes()) >> 0;
    if constexpr (changes_stress && granular::IsObjective<typename Models::strain>)
      return detail::in_a_row(filter.passes(), ForcesOfStrain{}.projections());
    else
      return filter.passes();
  }
  /// Returns the number of steps from one run of the stress filter to the next.
  int filter_period() const { return filter.period; }
  /// Returns the passes that compute `wall_force` for the present state, for output.
  auto wall_force_passes(Resolution const& resolution) const {
    return detail::as_std_tuple(detail::in_a_row(
        detail::in_fewer_sweeps(detail::in_a_row(density_passes(), force_passes(resolution), walls.velocity_passes(),
                                                 walls.stress_passes(rho(), gravity))),
        reaction_passes<Wall>(resolution)));
  }
  /// Returns the passes that compute `wall_force` of a body from the rates of the present state.
  template <BodyTag Body>
  auto reaction_passes(Resolution const& resolution) const {
    auto const reaction = detail::with_values(
        [&](auto const&... terms) { return Reaction(rho(), wall_lens(), terms...); }, motion_terms<Wall>(resolution));
    return std::tuple(pair_pass<Body>("scree::wall_force", over<Material>(reaction)));
  }

  /// Returns the acoustic CFL number, the ratio of the time step to h/c_s, which must not exceed largest_cfl() of the
  /// integrator.
  double acoustic_cfl() const { return cfl; }
  /// Returns the largest allowed speed of inflowing grains, m/s: half the speed of sound times `largest_mach`. If
  /// grains with speed u are stopped, the pressure rho c u compresses them by u/c. If there are several materials, the
  /// largest speed of sound is used. The result is infinite for laws whose stiffness depends on the state.
  double fastest_inlet() const {
    double const c = uniform_sound_speed();
    return c > 0 ? 0.5 * largest_mach * c : std::numeric_limits<double>::infinity();
  }
  /// Returns the largest speed, m/s, at which full layers of grains may rain in next to rough walls without a warning
  /// in 3D: a tenth of the speed of sound. Faster layers are stopped by the walls as a block and are under pressure
  /// before they reach the bed; part of that pressure remains (docs/theory/verification.md, poured beds). The result is
  /// infinite if fastest_inlet() is infinite.
  double fastest_rain() const {
    double const c = uniform_sound_speed();
    return c > 0 ? 0.1 * c : std::numeric_limits<double>::infinity();
  }
  /// Returns the modulus rho c^2, Pa, for the contact of rigid bodies, if the law has constant stiffness and either one
  /// density or densities of species; 0 for other laws.
  double contact_modulus() const {
    if constexpr (ConstantStiffness<Law> && has_one_density)
      return law.density() * sq(law.sound_speed());
    else if constexpr (requires { law.modulus_of_waves(); })
      return law.modulus_of_waves();
    else
      return 0;
  }

  static constexpr auto parameters() {
    return std::array{
        parameter("viscosity_speed", &Granular::viscosity_speed, "m/s",
                  "alpha c_s of the artificial viscosity, whatever the stiffness", allowed::at_least(0)),
        parameter("cfl", &Granular::cfl, "1", "step over h/c_s and over sqrt(h/|acceleration|)", allowed::above(0, 1)),
        parameter("largest_mach", &Granular::largest_mach, "1", "speed over that of sound at which a run stops",
                  allowed::above_or_infinite(0)),
        parameter("largest_number_density", &Granular::largest_number_density, "1",
                  "number density over that at rest at which a run with volume control stops",
                  allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a setting is out of range.
  void check() const {
    check_parameters(*this);
    check_setting(filter.period >= 1, "period of the filter (steps)", filter.period, "1 or more");
    check_settings_of(law);
    detail::check_response(law);
    check_settings_of(gravity);
    check_settings_of(filter);
    check_settings_of(volume_control);
    check_settings_of(walls);
    check_settings_of(advection);
    check_settings_of(viscosity);
    detail::with_values([](auto const&... each) { (check_settings_of(each), ...); }, given_forces());
  }
  /// Throws std::invalid_argument if a bed of depth H (m) would be crushed by its own weight: if rho g H exceeds the
  /// stiffness rho c^2, for laws of constant stiffness. If there are several materials, the largest speed of sound is
  /// used. A common cause is a wrong unit.
  void check_depth(double depth) const {
    double const g = std::abs(gravity.magnitude), c = uniform_sound_speed();
    if (c > 0 && g * depth > c * c)
      throw std::invalid_argument(detail::formatted(
          "scree: the weight of the material would crush it: g H is %.4g m^2/s^2 with a depth H of %.4g m, more than "
          "the square of the speed of sound, %.4g m/s; check the units of stiffness (Pa), density (kg/m^3) and "
          "lengths (m); if it is meant, set `start_checks = false`",
          g * depth, depth, c));
  }
  /// Returns the warning of a bed with a depth (m) that its weight compresses by a tenth or more, for laws of constant
  /// stiffness; empty for others.
  std::string warning_of_depth(double depth) const {
    return detail::warning_of_soft_bed(depth, std::abs(gravity.magnitude), uniform_sound_speed());
  }
  /// Returns the warnings, one per line, about gravity that acts upwards, a law without strength
  /// (is_without_strength()), a law that is ill-posed at every inertial number (is_never_well_posed()), and parameters
  /// of a law that are hardly meant (doubts_of_law()); empty if there are none.
  [[gnu::cold]] std::string warning() const {
    std::string text;
    auto const add = [&](std::string const& line) { text += (text.empty() ? "" : "\n") + line; };
    if (gravity.acts_upwards())
      add(
          detail::formatted("scree: warning: gravity acts upwards: its inclination is %.6g rad, %.4g degrees from "
                            "downwards; is it given in degrees?",
                            gravity.inclination, gravity.inclination * 57.29577951308232));
    if (is_without_strength(law))
      add("scree: warning: the cone of the law has neither friction nor cohesion, so that the material flows like a "
          "liquid; set it, for instance `.cone = plane_strain_cone({.friction_angle = 0.52})` (rad)");
    if (is_never_well_posed(law)) add(ill_posed);
    if (auto const doubts = doubts_of_law(law, gravity.magnitude); !doubts.empty()) add(doubts);
    return text;
  }
  /// Returns the warnings about the state of the material (WholeBody): one if the law has a circular cone in 3D and the
  /// material yields far from plane shear, one if the material rotates as a rigid body with PlainStrain, and one if
  /// PlainViscosity rules the flow. An entry is empty if there is nothing to warn about.
  template <class Whole>
  [[gnu::cold]] std::vector<std::string> warnings_of_state(Whole const& body) const {
    constexpr int dim = Whole::policy::dim;
    std::vector<std::string> all;
    if constexpr (dim == 3 && detail::OnCircularCone<Law> && std::is_same_v<section_in<dim>, CircularCone>)
      all.push_back(warning_beside_cone(beside_cone(law, body)));
    if constexpr (!Models::strain::corrected && !granular::IsObjective<typename Models::strain>)
      all.push_back(warning_of_rotation(rigid_rotation(body.untyped()), body.time()));
    if constexpr (has_one_density && std::is_same_v<typename Models::viscosity, PlainViscosity>)
      if (!is_without_strength(law))
        all.push_back(warning_of_viscosity(
            viscous_share(body.untyped(), viscosity_speed, law.density(), gravity.magnitude), viscosity_speed));
    return all;
  }
  /// Returns the limits on the time step from the speed of sound, the acceleration and the viscosity. Throws
  /// std::invalid_argument like check(), and if the section of the yield surface is invalid.
  auto limits(Resolution const& resolution) const {
    check();
    if (resolution.dimensions == 3)
      check_section<3>();
    else
      check_section<2>();
    double const h = resolution.smoothing_length;
    double const nu = effective_viscosity(viscosity_speed, h, resolution.dimensions);
    return std::tuple(
        acoustic_limit(h),
        limit("force", Magnitude<Acceleration>{}, [c = cfl, h](double a) { return c * std::sqrt(h / a); }),
        limit("viscous", 0.125 * h * h / nu));
  }
  /// Returns the bounds on a valid state: particles must not exceed `largest_mach` times the speed of sound; with
  /// volume control they must not cluster; if the law is ByGroup, they must belong to one of its groups; and if the
  /// density follows the mixture, the mixture must be valid.
  auto validity(Resolution const& resolution) const {
    auto const mach = bound("Mach number", granular::MachNumber<decltype(sound_speed())>{sound_speed()}, largest_mach,
                            "a stiffer law has faster waves; `largest_mach` of Granular allows more");
    return detail::as_std_tuple(
        detail::in_a_row(detail::Tuple(mach), clustering_bound(resolution), group_bound(), bound_of_mixture()));
  }

 private:
  template <class>
  friend struct Granular;

  static constexpr char const* ill_posed =
      "scree: warning: the friction of the law rises too little with the inertial number: the law is ill-posed at "
      "all of them, and results may depend on the spacing however small it is; a larger difference of mu_d and "
      "mu_s makes it well-posed in a range (docs/theory/laws.md, well-posedness)";

  template <int dim>
  void check_section() const {
    if constexpr (!std::is_same_v<section_in<dim>, CircularCone>) {
      detail::check_ratios<section_in<dim>>();
      detail::check_section(law);
    }
  }

  EvolvedLaw evolved_law() const {
    if constexpr (std::is_same_v<EvolvedLaw, Law>)
      return law;
    else
      return {law};
  }
  auto sound_speed() const {
    if constexpr (ConstantStiffness<Law>)
      return granular::ConstantSpeed{law.sound_speed()};
    else
      return granular::SpeedOfState<Law>{law};
  }
  /// Returns the speed of sound of a law of constant stiffness, m/s, or the largest one if there are several materials;
  /// 0 for other laws.
  double uniform_sound_speed() const {
    if constexpr (ConstantStiffness<Law>)
      return law.sound_speed();
    else if constexpr (requires { law.largest_sound_speed(); })
      return law.largest_sound_speed();
    else
      return 0;
  }
  auto acoustic_limit(double h) const {
    if constexpr (ConstantStiffness<Law>)
      return limit("acoustic", cfl * h / law.sound_speed());
    else if constexpr (requires { law.largest_sound_speed(); })
      return limit("acoustic", cfl * h / law.largest_sound_speed());
    else
      return limit("acoustic", sound_speed(), [c = cfl, h](double speed) { return c * h / speed; });
  }
  auto clustering_bound([[maybe_unused]] Resolution const& resolution) const {
    if constexpr (Volume::active)
      return detail::Tuple(bound("number density over that at rest", granular::NumberRatio{resolution.lattice_sum},
                                 largest_number_density,
                                 "particles have gathered; `largest_number_density` of Granular allows more"));
    else
      return detail::Tuple<>();
  }
  auto group_bound() const {
    if constexpr (requires { law.groups(); })
      return detail::Tuple(bound("number of a group beyond those of the law", granular::GroupOutside{law.groups()}, 0,
                                 "make the law and the solver from the same groups"));
    else
      return detail::Tuple<>();
  }
  auto bound_of_mixture() const {
    if constexpr (DensityOfMixture<Law>)
      return detail::Tuple(mixture_bound<Law::species_of_density>());
    else
      return detail::Tuple<>();
  }
  using ForcesOfStrain = granular::ForcesOfStrain<typename Models::strain, Walls>;
  static constexpr bool has_one_density = detail::GivesDensity<Law>;
  using MotionForces = granular::motion_forces<typename Models::forces, DensityOfMixture<Law>>;
  /// Returns the forces whose accelerations are added, including the momentum carried by species if the species have
  /// different densities.
  MotionForces motion_forces() const {
    if constexpr (DensityOfMixture<Law>)
      return std::tuple_cat(given_forces(), std::tuple(AccelerationByCarriedMomentum{}));
    else
      return given_forces();
  }
  auto rho() const {
    if constexpr (has_one_density)
      return UniformDensity{law.density()};
    else
      return DensityOfParticle{};
  }
  auto density_passes() const {
    if constexpr (has_one_density)
      return detail::Tuple<>();
    else
      return detail::Tuple(point_pass<Material>("scree::density", granular::DensityByLaw<Law>{law}));
  }
  template <bool Wanted>
  auto density_passes_if() const {
    if constexpr (Wanted)
      return density_passes();
    else
      return detail::Tuple<>();
  }
  auto stress_divergence() const {
    if constexpr (has_one_density)
      return StressDivergence<>{rho()};
    else
      return InterfaceStressDivergence<DensityOfParticle>{};
  }
  auto wall_lens() const {
    auto const lens = walls.lens(rho(), gravity);
    if constexpr (has_one_density)
      return lens;
    else
      return WithDensityOfTarget<std::remove_const_t<decltype(lens)>>{lens};
  }
  StrainRates<EvolvedLaw, Volume, typename Models::strain,
              Merge<typename Models::viscosity::computes, typename ForcesOfStrain::computes>>
  strain(Resolution const& resolution) const {
    return {evolved_law(),
            volume_control,
            resolution.lattice_sum,
            resolution.surface_asymmetry,
            resolution.smoothing_length,
            resolution.step};
  }
  template <BodyTag Body, class Lens, class Gradient>
  static auto strain_over(Lens const& lens, Gradient const& velocity_gradient) {
    if constexpr (Volume::active)
      return over_through<Body>(lens, velocity_gradient, FirstMomentSum{}, NumberDensitySum{});
    else
      return over_through<Body>(lens, velocity_gradient, FirstMomentSum{});
  }
  /// Returns the sum over walls in the strain rates: the term of the wall scheme if it has one and the gradient is not
  /// corrected, otherwise the sum of the velocity gradient through the lens of the scheme. A corrected gradient must
  /// treat all velocity differences in the same way.
  auto wall_strain() const {
    if constexpr (HasStrainTerm<Walls> && !Models::strain::corrected)
      return strain_over<Wall>(AsIs{}, walls.strain_term());
    else
      return strain_over<Wall>(wall_lens(), VelocityGradientSum{});
  }
  /// Returns the forces with the parameters that depend on the law.
  typename Models::forces given_forces() const {
    return detail::with_values(
        [c = uniform_sound_speed()](auto const&... each) {
          return typename Models::forces{granular::given_sound_speed(each, c)...};
        },
        forces);
  }
  auto force_passes(Resolution const& resolution) const {
    return detail::with_values(
        [&](auto const&... each) {
          return detail::in_a_row(ForcesOfStrain{}.passes(), granular::passes_of_force(each, rho(), resolution)...);
        },
        given_forces());
  }
  template <BodyTag Body>
  auto motion_terms(Resolution const& resolution) const {
    return detail::with_values(
        [&](auto const&... each) {
          return detail::in_a_row(detail::Tuple(stress_divergence()), wall_terms<Body>(),
                                  ForcesOfStrain{}.template terms<Body>(rho()),
                                  viscosity.template terms<Body>(rho(), viscosity_speed),
                                  granular::terms_of_force<Body>(each, rho(), resolution)...);
        },
        given_forces());
  }
  /// Returns the terms that the wall scheme adds to the divergence of the stress.
  template <BodyTag Body>
  auto wall_terms() const {
    if constexpr (std::is_same_v<Body, Wall> && HasForceTerm<Walls, decltype(this->rho())>)
      return detail::Tuple(walls.force_term(rho()));
    else
      return detail::Tuple<>();
  }
  template <BodyTag Body, class Lens>
  auto motion_over(Lens const& lens, Resolution const& resolution) const {
    return detail::with_values([&](auto const&... each) { return over_through<Body>(lens, each...); },
                               motion_terms<Body>(resolution));
  }
};

/// Models with a mistake that the compiler has already reported; the rest of Granular is not compiled for them.
template <class Models>
requires(!granular::explain_models<Models>()) struct Granular<Models> {
  using refused = Models;
};

}  // namespace scree

#include "instances.hpp"
#include "solvers.hpp"
