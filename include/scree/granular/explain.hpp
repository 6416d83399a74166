// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "forces.hpp"
#include "models.hpp"

// Compile-time error messages for models that do not fit Granular.
namespace scree::granular {

/// Whether a class has all the members of GranularModels.
template <class Models>
concept NamesModels = requires {
  typename Models::law;
  typename Models::section;
  typename Models::filter;
  typename Models::volume_control;
  typename Models::walls;
  typename Models::viscosity;
  typename Models::strain;
  typename Models::forces;
  typename Models::advection;
};

/// Returns whether all models fit Granular. Each model that does not fit fails a static assertion with its own message.
template <class Models>
constexpr bool explain_models() {
  constexpr bool names_all = NamesModels<Models>;
  static_assert(names_all,
                "Granular takes a class of models, struct Models : scree::GranularModels { using law = ...; }, which "
                "names each model or takes it from GranularModels: it takes no law");
  if constexpr (names_all) {
    constexpr bool has_law = detail::explain_law<typename Models::law>();
    using Named = typename Models::section;
    constexpr bool is_section = std::is_same_v<Named, SectionByLaw> || YieldSection<Named>;
    static_assert(
        is_section,
        "`section` is not a YieldSection: it is an empty struct with ratio(k, cosine) and least_ratio(k), which "
        "return the type of k");
    constexpr bool fits = !is_section || !has_law || section_fits<Named, typename Models::law>;
    static_assert(fits,
                  "`section` of the models needs a law that takes a section, as MuOfI does (`takes_section`): this law "
                  "has a yield surface of its own");
    static_assert(StressFilter<typename Models::filter>,
                  "`filter` is not a StressFilter: it needs period, history (Fields<> or Fields<Yielding>) and "
                  "passes()");
    static_assert(WallScheme<typename Models::walls>,
                  "`walls` is not a WallScheme: it needs velocity_passes(), stress_passes(rho, gravity) and lens(rho, "
                  "gravity)");
    using Volume = volume_control_of<typename Models::volume_control, typename Models::law>;
    static_assert(VolumeControl<Volume>,
                  "`volume_control` is not a VolumeControl: it needs `active` and, if that is true, "
                  "pressure_per_strain(p, K, denser) or pressure_per_strain(p, K, denser, sheared)");
    static_assert(ViscosityScheme<typename Models::viscosity>,
                  "`viscosity` is not a ViscosityScheme: it needs `computes` (Fields<> or Fields<StrainRate>) and "
                  "terms<Body>(rho, speed), which returns a tuple of terms");
    static_assert(StrainChoice<typename Models::strain>, "`strain` needs a constant `corrected`: true or false");
    static_assert(are_forces<typename Models::forces>, "`forces` must be a std::tuple of forces");
    static_assert(AdvectionScheme<typename Models::advection>,
                  "`advection` is not an AdvectionScheme: it needs `position` and stages(rho, passes)");
    return has_law && is_section && fits && StressFilter<typename Models::filter> &&
           WallScheme<typename Models::walls> && VolumeControl<Volume> && ViscosityScheme<typename Models::viscosity> &&
           StrainChoice<typename Models::strain> && are_forces<typename Models::forces> &&
           AdvectionScheme<typename Models::advection>;
  }
  return false;
}

}  // namespace scree::granular
