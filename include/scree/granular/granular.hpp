// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/adami.hpp"
#include "../core/setting.hpp"
#include "../laws/mu_of_i.hpp"
#include "../laws/volume_memory.hpp"
#include "../solver/limit.hpp"
#include "../solver/resolution.hpp"
#include "../solver/stage.hpp"
#include "../terms/artificial_viscosity.hpp"
#include "../terms/gravity.hpp"
#include "../terms/stress_divergence.hpp"
#include "../terms/wall_force.hpp"
#include "strain.hpp"
#include "stress_filter.hpp"

namespace scree {

namespace granular {

/// The rate of velocity of one particle.
struct Motion {
  Gravity gravity;
  using reads = Fields<>;
  using writes = Fields<Acceleration>;
  static constexpr bool stores_sums = false;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using vector = std::remove_cvref_t<decltype(total[acceleration])>;
    out[acceleration] = total[acceleration] + gravity.vector<vector>();
  }
};

/// The speed of sound at a particle, m/s: of a law of constant stiffness,
struct ConstantSpeed {
  double speed;
  using reads = Fields<>;
  template <class I>
  SCREE_FN double operator()(I const&) const {
    return speed;
  }
};
/// and of any law.
template <class Law>
struct SpeedOfState {
  Law law;
  using reads = Merge<Fields<Stress>, point_of<Law>>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(sound_speed_at(law, unpacked(i[stress]), i));
  }
};

/// Speed over the speed of sound.
template <class SoundSpeed>
struct MachNumber {
  SoundSpeed sound_speed;
  using reads = Merge<Fields<Velocity>, reads_of<SoundSpeed>>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(norm(i[velocity])) / sound_speed(i);
  }
};

struct NumberRatio {
  double at_rest;
  using reads = Fields<NumberDensity>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(i[number_density]) / at_rest;
  }
};

/// Returns an updated stress to the yield surface and adds up the yielding for the filter.
template <class Law, class OfFilter>
struct Admit {
  Law law;
  using history = Merge<typename Law::history, OfFilter>;
  using reads = Merge<Fields<Stress>, point_of<Law>, history>;
  using writes = Merge<Fields<Stress>, history>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    using Real = typename Packed::Scalar;
    constexpr int dim = Packed::RowsAtCompileTime == 4 ? 2 : 3;
    keep_history(i, out, typename Law::history{});
    StressTensor<Real> const trial = unpacked(i[stress]), admitted = law.admissible(trial, i, out);
    out[stress] = packed<dim>(admitted);
    if constexpr (OneOf<Yielding, OfFilter>) {
      StressTensor<Real> const taken = trial - admitted;
      out[yielding] = i[yielding] + equivalent_shear_stress(deviator_of(taken)) / bulk_modulus_at(law, trial, i);
    }
    keep_what_is_not_finite(i, out, writes{});
  }

 private:
  template <class I, class O, class... Fs>
  SCREE_FN static void keep_history(I const& i, O& out, Fields<Fs...>) {
    ((out[Fs{}] = i[Fs{}]), ...);
  }
  /// A law may turn NaN into a number. The NaN is kept, so that the run stops.
  template <class I, class O, class... Fs>
  SCREE_FN static void keep_what_is_not_finite(I const& i, O& out, Fields<Fs...>) {
    (keep(i, out, Fs{}), ...);
  }
  template <class I, class O, class F>
  SCREE_FN static void keep(I const& i, O& out, F field) {
    if (!detail::is_finite(i[field])) out[field] = i[field];
  }
};

}  // namespace granular

/// Momentum balance and constitutive law of a dry granular material of constant density between walls (Zhu et al. 2024,
/// sections 2 and 3).
template <class Law = MuOfI<>, class Filter = LinearFilter, class Volume = NoVolumeControl, class Walls = AdamiWalls,
          class Strain = PlainStrain>
struct Granular {
  static_assert(detail::explain_law<Law>());
  static_assert(StressFilter<Filter>,
                "`Filter` is no StressFilter: it needs period, history (Fields<> for none) and passes()");

  Law law = {};
  Gravity gravity = {};
  double viscosity_speed = 0.5;  ///< alpha c_s of the artificial viscosity, m/s
  double cfl = 0.2;              ///< step in h/c_s and in sqrt(h/|acceleration|), -
  Filter filter = {};
  Volume volume_control = {};
  Walls walls = {};
  double largest_mach = 1;            ///< speed over the speed of sound at which a run stops, -; infinite: never
  double largest_number_density = 2;  ///< over its value at rest, with volume control; stops a run, -; infinite: never

  using evolves = Merge<Fields<Position, Velocity, Stress>, typename Law::history, typename Filter::history>;

  /// The stress from position and velocity, then velocity and position from the new stress.
  auto stages(Resolution const& resolution) const {
    auto const rates = sweep("scree::strain_rates", strain(resolution), strain_terms());
    auto const forces = sweep("scree::acceleration", granular::Motion{gravity}, motion_terms());
    auto const admit = point_pass<Material>("scree::admit", granular::Admit<Law, typename Filter::history>{law});
    using Evolved = Merge<Fields<Stress>, typename Law::history, typename Filter::history>;
    return std::tuple(
        stage<Evolved>(std::tuple_cat(walls.velocity_passes(), rates), std::tuple(admit)),
        stage<Fields<Velocity, Position>>(std::tuple_cat(walls.stress_passes(law.density(), gravity), forces)));
  }
  auto filters(Resolution const&) const { return filter.passes(); }
  int filter_period() const { return filter.period; }
  /// Passes that compute `wall_force` for the present state; for output.
  auto wall_force_passes(Resolution const&) const {
    auto const reaction = std::apply(
        [&](auto const&... terms) {
          return Reaction(UniformDensity{law.density()}, walls.lens(law.density(), gravity), terms...);
        },
        motion_terms());
    return std::tuple_cat(fused(std::tuple_cat(walls.velocity_passes(), walls.stress_passes(law.density(), gravity))),
                          std::tuple(pair_pass<Wall>("scree::wall_force", over<Material>(reaction))));
  }

  /// Throws std::invalid_argument where a setting is out of range.
  void check() const {
    check_setting(cfl > 0 && cfl <= 1, "cfl", cfl, "above 0 and at most 1");
    check_setting(viscosity_speed >= 0, "viscosity_speed (m/s)", viscosity_speed, "0 or more");
    check_setting(largest_mach > 0, "largest_mach", largest_mach, "above 0");
    check_settings_of(law);
    check_settings_of(filter);
  }
  /// Throws as check() does.
  auto limits(Resolution const& resolution) const {
    check();
    double const h = resolution.smoothing_length;
    double const nu = effective_viscosity(viscosity_speed, h, resolution.dimensions);
    return std::tuple(
        acoustic_limit(h),
        limit("force", Magnitude<Acceleration>{}, [c = cfl, h](double a) { return c * std::sqrt(h / a); }),
        limit("viscous", 0.125 * h * h / nu));
  }
  /// Particles must stay slower than sound and must not cluster.
  auto validity(Resolution const& resolution) const {
    auto const mach = bound("Mach number", granular::MachNumber{sound_speed()}, largest_mach,
                            "a stiffer law has faster waves; `largest_mach` of Granular allows more");
    if constexpr (Volume::active)
      return std::tuple(mach, bound("number density over that at rest", granular::NumberRatio{resolution.lattice_sum},
                                    largest_number_density,
                                    "particles have gathered; `largest_number_density` of Granular allows more"));
    else
      return std::tuple(mach);
  }

 private:
  auto sound_speed() const {
    if constexpr (ConstantStiffness<Law>)
      return granular::ConstantSpeed{law.sound_speed()};
    else
      return granular::SpeedOfState<Law>{law};
  }
  auto acoustic_limit(double h) const {
    if constexpr (ConstantStiffness<Law>)
      return limit("acoustic", cfl * h / law.sound_speed());
    else
      return limit("acoustic", sound_speed(), [c = cfl, h](double speed) { return c * h / speed; });
  }
  StrainRates<Law, Volume, Strain> strain(Resolution const& resolution) const {
    return {law, volume_control, resolution.lattice_sum, resolution.surface_asymmetry};
  }
  static auto strain_terms() {
    if constexpr (Volume::active)
      return std::tuple(VelocityGradientSum{}, FirstMomentSum{}, NumberDensitySum{});
    else
      return std::tuple(VelocityGradientSum{}, FirstMomentSum{});
  }
  auto motion_terms() const {
    UniformDensity const rho{law.density()};
    return std::tuple(StressDivergence<>{rho}, ArtificialViscosity<>{rho, viscosity_speed});
  }
  /// Terms over the material and over the walls as seen through their lens.
  template <class Then, class... Terms>
  auto sweep(char const* label, Then const& then, std::tuple<Terms...> const& terms) const {
    auto const lens = walls.lens(law.density(), gravity);
    return std::apply(
        [&](Terms const&... each) {
          return std::tuple(
              pair_pass_then<Material>(label, then, over<Material>(each...), over_through<Wall>(lens, each...)));
        },
        terms);
  }
};

}  // namespace scree
