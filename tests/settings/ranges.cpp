// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/flow_consistency.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/motion/delayed.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/oscillating_shear.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/motion/translation.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/segregation/schlick_closure.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/trewhela_closure.hpp>
#include <scree/segregation/under_gravity.hpp>

#include <laws/hochstetten.hpp>
#include <settings/range.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

// Every parameter of every model, with the ends of its range.
namespace scree::test::ranges_tests {
namespace {

Elastic const elastic{1e6, 0.3, 1500};
MuOfI<> const sand{.elastic = elastic, .grains = {1e-3}};

}  // namespace

TEST_CASE("settings: laws") {
  range(elastic, OF(young), "young (Pa)", "above 0", {tiny, huge}, {0, -1, inf});
  range(elastic, OF(poisson), "poisson (-)", "above -1 and below 0.5", {-0.999, 0, 0.499}, {-1, 0.5});
  range(elastic, OF(rest_density), "rest_density (kg/m^3)", "above 0", {tiny, huge}, {0, -1, inf});

  range(sand, OF(elastic.young), "young (Pa)", "above 0", {}, {0});
  range(sand, OF(mu_s), "mu_s (-) of MuOfI", "0 or more", {0, sand.mu_d}, {-tiny, inf});
  range(sand, OF(mu_d), "mu_d (-) of MuOfI", "mu_s or more", {sand.mu_s, 10}, {0, 0.381, inf});
  auto const with_friction = [](double mu_s, double mu_d) { return MuOfI<>{elastic, {1e-3}, mu_s, mu_d}; };
  for (double const degrees : {10.01, 21.0, 1e9}) {
    CHECK_THROWS_WITH(
        with_friction(degrees, 1.5 * degrees).check(),
        "scree: mu_s (-) of MuOfI must be at most 10: it is the tangent of a friction angle, not the angle "
        "in degrees, not " +
            detail::short_text(degrees));
    CHECK_THROWS_WITH(with_friction(0.4, degrees).check(),
                      ContainsSubstring("scree: mu_d (-) of MuOfI must be at most 10: it is the tangent"));
  }
  range(sand, OF(I0), "I0 (-) of MuOfI", "above 0", {tiny, huge}, {0, -1, inf});
  range(sand, OF(grain_density), "grain_density (kg/m^3) of MuOfI", "above 0", {1500, huge}, {0, inf});
  range(sand, OF(regularisation), "regularisation (1/s) of MuOfI", "above 0", {tiny, huge}, {0, inf});
  range(sand, OF(grains.diameter), "diameter (m)", "above 0", {tiny, huge}, {0, -1e-3, inf});
  range(BidisperseGrains{1e-3, 2e-3}, OF(d_small), "d_small (m)", "above 0", {tiny, huge}, {0, inf});
  range(BidisperseGrains{1e-3, 2e-3}, OF(d_large), "d_large (m)", "above 0", {tiny, huge}, {0, inf});

  RisingMuOfI<> const rising{sand};
  range(rising, OF(mu_inf), "mu_inf (-) of RisingMuOfI", "0 to 10", {0, 10}, {-tiny, 10.01, inf});
  range(rising, OF(mu_d), "mu_d (-) of MuOfI", "mu_s or more", {sand.mu_s, 10}, {0.381});

  DruckerPrager const soil{elastic, {.friction = 0.4, .cohesion = 100, .dilatancy = 0.1}};
  range(soil, OF(elastic.young), "young (Pa)", "above 0", {}, {0});
  range(soil, OF(cone.friction), "friction (-) of the cone",
        "from 0 to 1.732, the root of J2 over the pressure and not an angle: plane_strain_cone() makes it from a "
        "friction "
        "angle (rad)",
        {0.1, std::sqrt(3.0)}, {-0.1, 1.74, 10, 30, inf});
  range(soil, OF(cone.cohesion), "cohesion (Pa) of the cone", "0 or more", {0, huge}, {-1, inf});
  range(soil, OF(cone.dilatancy), "dilatancy (-) of the cone", "from 0 to its friction", {0, 0.4}, {-0.1, 0.41});
  for (double const phi : {0.0, 0.3, 1.5})
    for (double const psi : {0.0, phi})
      for (auto* cone : {plane_strain_cone, compression_cone})
        CHECK_NOTHROW((DruckerPrager{elastic, cone({.friction_angle = phi, .dilatancy_angle = psi})}.check()));

  Hypoplastic const hypoplastic = hochstetten();
  range(hypoplastic, OF(critical_angle), "critical_angle (rad)", "above 0 and below pi/2", {0.2}, {0, 1.6});
  range(hypoplastic, OF(granulate_hardness), "granulate_hardness (Pa)", "above 0", {tiny, huge}, {0, inf});
  range(hypoplastic, OF(exponent), "exponent (-)", "above 0 and below 1", {0.01, 0.99}, {0, 1});
  range(hypoplastic, OF(e_d0), "e_d0 (-)", "above 0", {0.5}, {0, -1});
  range(hypoplastic, OF(e_c0), "e_c0 (-)", "above e_d0", {1}, {hypoplastic.e_d0, 0.1});
  range(hypoplastic, OF(e_i0), "e_i0 (-)", "above e_c0", {hypoplastic.e_c0 + 0.01}, {hypoplastic.e_c0, inf});
  range(hypoplastic, OF(alpha), "alpha (-)", "0 or more", {0}, {-0.1, inf});
  range(hypoplastic, OF(beta), "beta (-)", "0 or more", {0, huge}, {-0.1, inf});
  range(hypoplastic, OF(rest_density), "rest_density (kg/m^3)", "above 0", {tiny, huge}, {0, inf});
  range(hypoplastic, OF(least_pressure), "least_pressure (Pa)", "above 0", {tiny, huge}, {0, inf});
}

TEST_CASE("settings: laws around others check these too") {
  TensionCutoff<MuOfI<>> const cut{sand, 10};
  range(cut, OF(tensile_strength), "tensile_strength (Pa) of TensionCutoff", "0 or more", {0, huge}, {-1, inf});
  range(cut, OF(grains.diameter), "diameter (m)", "above 0", {}, {0});
  VolumeMemory<MuOfI<>> const memory{sand};
  range(memory, OF(largest_opening), "largest_opening (-) of VolumeMemory", "0 or more", {0, inf}, {-0.1});
  range(memory, OF(grains.diameter), "diameter (m)", "above 0", {}, {0});
  VolumeMemory<TensionCutoff<MuOfI<>>> const both{cut};
  range(both, OF(tensile_strength), "tensile_strength (Pa) of TensionCutoff", "0 or more", {}, {-1});
  range(both, OF(elastic.young), "young (Pa)", "above 0", {}, {0});

  auto const layers = Groups<2>().add("lower", {{0, 0}}).add("upper", {{0, 1}});
  auto bad = memory;
  bad.mu_s = -1;
  ByGroup<VolumeMemory<MuOfI<>>> law(layers);
  law.set(0, memory);
  CHECK_THROWS_WITH(law.check(), ContainsSubstring("group 1 of ByGroup has no law"));
  law.set(1, bad);
  CHECK_THROWS_WITH(law.check(), "scree: mu_s (-) of MuOfI must be 0 or more, not -1 (group 1 of ByGroup)");
  CHECK_NOTHROW(law.set(1, memory).check());
}

TEST_CASE("settings: granular mechanics") {
  struct Models : GranularModels {
    using volume_control = VolumeConsistency;
    using forces = std::tuple<TensileRepulsion>;
    using advection = Xsph;
  };
  Granular<Models> const granular{.law = sand};
  range(granular, OF(law.I0), "I0 (-) of MuOfI", "above 0", {}, {0});
  range(granular, OF(gravity.magnitude), "magnitude (m/s^2) of Gravity", "0 or more, because it acts downwards already",
        {0, 1.62, huge}, {-9.81, -tiny, inf, -inf});
  range(granular, OF(gravity.inclination), "inclination (rad) of Gravity",
        "from -pi to pi, in radians and not in degrees", {-std::numbers::pi, -2, 2, std::numbers::pi},
        {-30, 3.15, 30, inf});
  range(granular, OF(viscosity_speed), "viscosity_speed (m/s)", "0 or more", {0, huge}, {-1, inf});
  range(granular, OF(cfl), "cfl (-)", "above 0 and at most 1", {tiny, 1}, {0, 1.01, inf});
  range(granular, OF(largest_mach), "largest_mach (-)", "above 0", {tiny, inf}, {0, -1});
  range(granular, OF(largest_number_density), "largest_number_density (-)", "above 0", {tiny, inf}, {0, -1});
  range(granular, OF(filter.period), "period of the filter (steps)", "1 or more", {1, 1000}, {0, -30});
  range(granular, OF(filter.full_at), "full_at (-) of LinearFilter", "above 0", {tiny, inf}, {0, -1});
  range(granular, OF(volume_control.per_strain), "per_strain (-) of VolumeConsistency", "0 or more", {0, huge},
        {-1, inf});
  range(granular, OF(volume_control.largest_strain), "largest_strain (-) of VolumeConsistency", "0 or more", {0, inf},
        {-1});
  FlowConsistency const flow;
  range(flow, OF(per_strain), "per_strain (-) of FlowConsistency", "0 or more", {0, huge}, {-1, inf});
  range(flow, OF(per_strain_unloaded), "per_strain_unloaded (-) of FlowConsistency", "0 or more", {0, huge}, {-1, inf});
  range(flow, OF(rest), "rest (-) of FlowConsistency", "0 or more", {0, 1e-2}, {-1, inf});
  range(flow, OF(flow), "flow (-) of FlowConsistency", "above 0, and not below `rest`", {1, huge}, {0, inf});
  range(flow, OF(largest_strain), "largest_strain (-) of FlowConsistency", "0 or more", {0, inf}, {-1});
  auto const repulsion = [](auto& m) -> auto& { return std::get<0>(m.forces).epsilon; };
  range(granular, repulsion, "epsilon (-) of TensileRepulsion", "0 or more", {0, huge}, {-1, inf});
  range(granular, OF(advection.epsilon), "epsilon (-) of Xsph", "0 to 1", {0, 1}, {-0.1, 1.1});
}

TEST_CASE("settings: segregation, alone and with mechanics") {
  range(ConstantClosure{}, OF(velocity), "velocity (m/s) of ConstantClosure", "0 or more", {0, huge}, {-1, inf});
  range(ConstantClosure{}, OF(diffusivity), "diffusivity (m^2/s) of ConstantClosure", "0 or more", {0, huge},
        {-1, inf});
  ShearRateClosure const closure{.d_small = 1e-3, .d_large = 2e-3};
  range(closure, OF(chi_V), "chi_V (-) of the closure", "0 or more", {0, huge}, {-1, inf});
  range(closure, OF(chi_D), "chi_D (-) of the closure", "0 or more", {0, huge}, {-1, inf});
  range(closure, OF(d_small), "d_small (m) of the closure", "above 0", {tiny, huge}, {0, inf});
  range(closure, OF(d_large), "d_large (m) of the closure", "above 0", {tiny, huge}, {0, inf});
  SchlickClosure const schlick{.d_small = 1e-3, .d_large = 2e-3};
  range(schlick, OF(S), "S (-) of SchlickClosure", "0 or more", {0, huge}, {-1, inf});
  range(schlick, OF(A), "A (-) of SchlickClosure", "0 or more", {0, huge}, {-1, inf});
  range(schlick, OF(d_small), "d_small (m) of SchlickClosure", "above 0", {tiny, 2e-3}, {0, inf});
  range(schlick, OF(d_large), "d_large (m) of SchlickClosure", "`d_small` or more", {1e-3, huge}, {0, 9e-4, inf});
  TrewhelaClosure const trewhela{.d_small = 1e-3, .d_large = 2e-3};
  range(trewhela, OF(A), "A (-) of TrewhelaClosure", "0 or more", {0, huge}, {-1, inf});
  range(trewhela, OF(B), "B (-) of TrewhelaClosure", "0 or more", {0, huge}, {-1, inf});
  range(trewhela, OF(C), "C (-) of TrewhelaClosure", "above 0", {tiny, huge}, {0, inf});
  range(trewhela, OF(E), "E (-) of TrewhelaClosure", "0 or more", {0, huge}, {-1, inf});
  range(trewhela, OF(d_small), "d_small (m) of TrewhelaClosure", "above 0", {tiny, 2e-3}, {0, inf});
  range(trewhela, OF(d_large), "d_large (m) of TrewhelaClosure", "`d_small` or more", {1e-3, huge}, {0, 9e-4, inf});
  range(trewhela, OF(grain_density), "grain_density (kg/m^3) of TrewhelaClosure", "above 0", {tiny, huge}, {0, inf});
  range(trewhela, OF(buoyancy), "buoyancy (-) of TrewhelaClosure", "0 to 1", {0, 1}, {-0.1, 1.1, inf});
  range(SegregationFlux{}, OF(amplitude), "amplitude (-) of the segregation flux", "above 0 and below 1e+09",
        {tiny, 1e8}, {0, 1e9});
  range(SegregationFlux{}, OF(asymmetry), "asymmetry (-) of the segregation flux", "0 to 1", {0, 1}, {-0.1, 1.1});
  auto const scheme = [&](auto const& segregation) {
    range(segregation, OF(closure.chi_V), "chi_V (-) of the closure", "0 or more", {}, {-1});
    range(segregation, OF(flux.asymmetry), "asymmetry (-) of the segregation flux", "0 to 1", {}, {2});
    range(segregation, OF(step.diffusion), "diffusion (-) of TransportStep", "above 0 and at most 1", {tiny, 1},
          {0, 1.01});
    range(segregation, OF(step.segregation), "segregation (-) of TransportStep", "above 0 and at most 1", {tiny, 1},
          {0, 1.01});
  };
  ConservativeSegregation<ShearRateClosure> const conservative{closure};
  scheme(conservative);
  scheme(HybridSegregation<ShearRateClosure>{closure});
  UnderGravity<ConservativeSegregation<ShearRateClosure>> const under{conservative};
  range(under, OF(segregation.flux.asymmetry), "asymmetry (-) of the segregation flux", "0 to 1", {}, {2});
  range(under, OF(gravity.inclination), "inclination (rad) of Gravity", "from -pi to pi, in radians and not in degrees",
        {1}, {20, inf});

  auto const joined = combine(Granular<>{.law = sand}, conservative);
  range(joined, OF(mechanics.cfl), "cfl (-)", "above 0 and at most 1", {}, {2});
  range(joined, OF(transport.step.diffusion), "diffusion (-) of TransportStep", "above 0 and at most 1", {}, {2});
  range(joined, OF(period), "period (steps) of the transport in Combined", "1 or more", {1, 100}, {0, -1});
}

TEST_CASE("settings: motions") {
  range(Rotation{}, OF(rate), "rate (rad/s) of Rotation", "finite", {-huge, 0, huge}, {inf});
  range(Rotation{}, OF(angle_per_step), "angle_per_step (rad) of Rotation", "above 0", {tiny, inf}, {0, -1});
  range(Rotation{}, OF(centre_x), "centre_x (m) of Rotation", "finite", {-1, 1}, {inf});
  range(Rotation{}, OF(centre_z), "centre_z (m) of Rotation", "finite", {-1, 1}, {inf});
  range(Translation<2>{}, OF(speed[1]), "speed (m/s) of Translation", "finite", {-1, 1}, {inf});
  range(Translation<3>{}, OF(growth[2]), "growth (m/s^2) of Translation", "finite", {-1, 1}, {-inf});
  RotationAbout::Parameters const about{};
  range(about, OF(rate), "rate (rad/s) of RotationAbout", "finite", {-huge, 0, huge}, {inf});
  range(about, OF(axis[0]), "axis (-) of RotationAbout", "finite", {-1, 1}, {inf});
  range(about, OF(centre[1]), "centre (m) of RotationAbout", "finite", {-1, 1}, {inf});
  range(about, OF(angle_per_step), "angle_per_step (rad) of RotationAbout", "above 0", {tiny, inf}, {0, -1});
  Oscillation<2> const oscillation{.amplitude = {1, 0}};
  range(oscillation, OF(amplitude[1]), "amplitude (m) of Oscillation", "finite", {-1, 1}, {inf});
  range(oscillation, OF(period), "period (s) of Oscillation", "above 0", {tiny, huge}, {0, -1, inf});
  range(oscillation, OF(phase), "phase (rad) of Oscillation", "finite", {-1, 1}, {inf});
  range(oscillation, OF(angle_per_step), "angle_per_step (rad) of Oscillation", "above 0", {tiny}, {0, -1});
  range(OscillatingShear{}, OF(amplitude), "amplitude (-) of OscillatingShear", "finite", {-1, 1}, {inf});
  range(OscillatingShear{}, OF(period), "period (s) of OscillatingShear", "above 0", {tiny, huge}, {0, -1, inf});
  range(OscillatingShear{}, OF(floor), "floor (m) of OscillatingShear", "finite", {-1, 1}, {inf});
  range(OscillatingShear{}, OF(strain_per_step), "strain_per_step (-) of OscillatingShear", "above 0", {tiny}, {0, -1});
  Tabulated<2> const gate({0, 1}, {{0, 0}, {0, 1}});
  range(gate, OF(interval_per_step), "interval_per_step (-) of Tabulated", "above 0", {tiny}, {0, -1});

  Delayed<Rotation> const delayed{.start = 1, .stop = 2};
  range(delayed, OF(start), "start (s) of Delayed", "finite", {-1, 2}, {-inf});
  range(delayed, OF(stop), "stop (s) of Delayed", "start or later", {1, inf}, {0.99, -1});
  range(delayed, OF(motion.rate), "rate (rad/s) of Rotation", "finite", {}, {inf});
  CHECK_NOTHROW((AnyMotion<Rotation, Delayed<Rotation>>{}.check()));
  CHECK_THROWS_WITH((AnyMotion<Rotation, Delayed<Rotation>>(Delayed<Rotation>{{}, 3, 2}).check()),
                    "scree: stop (s) of Delayed must be start or later, not 2");
  MotionOfGroups<3, Rotation, Tabulated<2>> groups(3);
  CHECK_NOTHROW(groups.set(0, gate).check());
  CHECK_THROWS_WITH(groups.set(1, Rotation{.rate = inf}).check(),
                    "scree: rate (rad/s) of Rotation must be finite, not inf (group 1 of MotionOfGroups)");
}

TEST_CASE("settings: a table with a number that is not finite, and soils") {
  CHECK_THROWS_WITH(Tabulated<2>({0, 1}, {{0, 0}, {0, nan}}), ContainsSubstring("row 1 of the table of a motion"));
  CHECK_THROWS_WITH(Tabulated<2>({0, inf}, {{0, 0}, {0, 1}}), ContainsSubstring("row 1 of the table of a motion"));
  CHECK_THROWS_WITH(plane_strain_cone({.friction_angle = 1.6}),
                    "scree: friction_angle (rad) of MohrCoulomb must be from 0 to below pi/2, not 1.6");
  CHECK_THROWS_WITH(compression_cone({.friction_angle = 0.5, .cohesion = -1}),
                    "scree: cohesion (Pa) of MohrCoulomb must be 0 or more, not -1");
  CHECK_THROWS_WITH(compression_cone({.friction_angle = 0.5, .dilatancy_angle = 0.6}),
                    "scree: dilatancy_angle (rad) of MohrCoulomb must be from 0 to friction_angle, not 0.6");
}

}  // namespace scree::test::ranges_tests
