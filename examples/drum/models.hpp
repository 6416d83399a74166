// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include <scree/app/list_of_sizes.hpp>
#include <scree/granular/granular.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/segregation/schlick_closure.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/trewhela_closure.hpp>
#include <scree/system/periodic.hpp>

// Converts the options of a case to models of the library, in SI units.
namespace drum {

template <class Grains>
using Law = scree::VolumeMemory<scree::MuOfI<Grains>>;
template <class Grains>
Law<Grains> law(Options const& o, Grains const& grains) {
  auto const& m = o.material;
  return {{.elastic = {.young = young(o), .poisson = m.poisson, .rest_density = m.density},
           .grains = grains,
           .mu_s = m.mu_s,
           .mu_d = m.mu_d,
           .I0 = m.I0,
           .grain_density = m.grain_density},
          o.numerics.volume_control != VolumeControl::none};  // whether it remembers
}
inline scree::VolumeConsistency volume_control(Options const& o) {
  bool const active = o.numerics.volume_control == VolumeControl::consistency;
  return {.per_strain = active ? o.numerics.volume_rate : 0};
}

/// One of the library's filters of the stress, by name.
struct Filter {
  StressFilter kind = StressFilter::none;
  int period = 1;
  using history = scree::LinearFilter::history;
  auto passes() const {
    return std::tuple_cat(scree::only_if(kind == StressFilter::shepard, scree::ShepardFilter{}.passes()),
                          scree::only_if(kind == StressFilter::linear, scree::LinearFilter{}.passes()));
  }
};
inline Filter filter(Options const& o) { return {o.numerics.stress_filter, o.numerics.filter_period}; }

/// V and D by (2.7), by the ratio of sizes, by this and the pressure, constant, or zero.
struct SegregationClosure {
  scree::ShearRateClosure by_shear_rate;
  scree::SchlickClosure by_ratio;
  scree::TrewhelaClosure by_pressure;
  scree::ConstantClosure constant;
  using reads = scree::reads_of<scree::TrewhelaClosure>;
  using writes = scree::writes_of<scree::ShearRateClosure>;
  template <class I, class Out>
  SCREE_FN void operator()(I const& i, Out& out) const {
    using namespace scree::fields;
    by_shear_rate(i, out);
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    if (by_ratio.S > 0) by_ratio(i, out);
    if (by_pressure.B > 0) by_pressure(i, out);
    out[segregation_velocity] = Real(out[segregation_velocity] + constant.velocity);
    out[diffusivity] = Real(out[diffusivity] + constant.diffusivity);
  }
  std::string warning() const {
    return by_ratio.S > 0 ? by_ratio.warning() : by_pressure.B > 0 ? by_pressure.warning() : "";
  }
  SegregationClosure under(scree::Gravity const& gravity) const {
    auto changed = *this;
    changed.by_pressure = by_pressure.under(gravity);
    return changed;
  }
  template <class I>
  SCREE_FN bool holds_at(I const& i) const {
    return by_pressure.B > 0 ? by_pressure.holds_at(i) : true;
  }
  std::string warning_beyond(double share, double way) const { return by_pressure.warning_beyond(share, way); }
};
inline SegregationClosure closure(Options const& o) {
  auto const& s = o.segregation;
  bool const sheared = s.closure == Closure::shear_rate, fixed = s.closure == Closure::constant;
  return {.by_shear_rate = {.chi_V = sheared ? s.chi_V : 0,
                            .chi_D = sheared ? s.chi_D : 0,
                            .d_small = o.material.d_small,
                            .d_large = o.material.d_large},
          .by_ratio = {.S = s.closure == Closure::schlick ? scree::SchlickClosure().S : 0,
                       .d_small = o.material.d_small,
                       .d_large = o.material.d_large},
          .by_pressure = {.B = s.closure == Closure::trewhela ? scree::TrewhelaClosure().B : 0,
                          .d_small = o.material.d_small,
                          .d_large = o.material.d_large,
                          .grain_density = o.material.grain_density},
          .constant = {.velocity = fixed ? s.V : 0, .diffusivity = fixed ? s.D : 0}};
}
inline scree::SegregationFlux flux(Options const& o) {
  return {.amplitude = flux_amplitude(o), .asymmetry = flux_asymmetry(o)};
}

/// Steps from one evaluation of the segregation to the next.
inline int segregation_period(Options const& o) {
  double const step = o.numerics.cfl * smoothing_length(o) / sound_speed(o);
  return std::max(1, static_cast<int>(o.segregation.interval / step));
}

template <class Grains>
struct Models : scree::GranularModels {
  using law = Law<Grains>;
  using section = scree::CircularCone;  // that of the paper, in slices in space too
  using filter = Filter;
  using volume_control = scree::VolumeConsistency;
  using walls = scree::AdamiWalls;
};
template <class Grains>
scree::Granular<Models<Grains>> mechanics(Options const& o, Grains const& grains) {
  return {.law = law(o, grains),
          .gravity = {.magnitude = o.geometry.gravity},
          .viscosity_speed = o.numerics.viscosity_speed,
          .cfl = o.numerics.cfl,
          .filter = filter(o),
          .volume_control = volume_control(o)};
}

/// A mixture of small and large grains.
template <Scheme scheme>
struct TwoSizes {
  using Grains = scree::BidisperseGrains;
  using Segregation =
      std::conditional_t<scheme == Scheme::conservative, scree::ConservativeSegregation<SegregationClosure>,
                         scree::HybridSegregation<SegregationClosure>>;
  static Grains grains(Options const& o) { return {.d_small = o.material.d_small, .d_large = o.material.d_large}; }
  static Segregation segregation(Options const& o) { return {closure(o), flux(o)}; }
};
/// A mixture of the sizes of a list.
struct ListOfSizes : scree::app::ListOfSizes {
  static Grains grains(Options const& o) { return scree::app::ListOfSizes::grains(o.species); }
  static Segregation segregation(Options const& o) {
    auto found = scree::app::ListOfSizes::segregation(o.species);
    if (o.segregation.closure == Closure::none)  // of one size: no ratio to warn of
      found.closure = scree::SizeRatioClosure<species>{
          .diameters = scree::Vec<species, double>::Constant(o.species.diameters[0]), .S = 0, .A = 0};
    return found;
  }
};

/// Clockwise in the plane of x (right) and z (up).
inline scree::Rotation motion(Options const& o) { return {.rate = -angular_velocity(o)}; }

template <int Dim>
std::vector<scree::Period> periods(Options const& o) {
  if (Dim == 2 || o.geometry.ends == Ends::walled) return {};
  return {{.axis = 1, .low = -o.geometry.length / 2, .high = o.geometry.length / 2}};
}

}  // namespace drum
