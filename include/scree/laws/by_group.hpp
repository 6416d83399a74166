// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/groups.hpp"
#include "law.hpp"
#include "response.hpp"
#include "section.hpp"

#include <algorithm>
#include <stdexcept>

namespace scree {

/// A constitutive law with different parameters for each group of particles, for layers of different materials:
///
///     Groups<2> soil;
///     soil.add("sand", below).add("gravel", above);
///     ByGroup<MuOfI<>> law(soil);
///     law.set(soil.number("sand"), sand).set(soil.number("gravel"), gravel);
///
/// The solver must be constructed from the same groups. Every group needs parameters. `Capacity` is the largest number
/// of groups; a larger capacity adds no code to compile. A modifier goes inside ByGroup:
/// ByGroup<VolumeMemory<MuOfI<>>>.
template <class Law, int Capacity = 8>
class ByGroup {
  static_assert(Capacity > 0, "ByGroup<Law, Capacity> needs room for at least one group");
  static_assert(detail::explain_law<Law>());
  static_assert(!detail::explain_law<Law>() || detail::GivesDensity<Law>,
                "the law in ByGroup needs density(): a density that follows the mixture cannot differ between groups");

 public:
  using reads = Merge<Fields<Group>, typename Law::reads>;
  using history = typename Law::history;
  static constexpr bool cohesionless = Cohesionless<Law>;
  static constexpr bool circular = !requires { requires !Law::circular; };
  static constexpr bool takes_section = TakesSection<Law>;

  /// Constructs a law without groups, for which check() throws.
  ByGroup() = default;
  /// Constructs a law for these groups. Throws std::invalid_argument if there are more groups than `Capacity`.
  template <int Dim>
  explicit ByGroup(Groups<Dim> const& groups) : groups_(groups.count()) {
    if (groups_ > Capacity)
      throw std::invalid_argument(detail::formatted(
          "scree: ByGroup<Law, %d> holds the parameters of at most %d groups, not %d: raise its second "
          "template argument",
          Capacity, Capacity, groups_));
  }
  /// Sets the parameters of one group and returns this object, so that calls can be chained. Throws
  /// std::invalid_argument if the group does not exist.
  ByGroup& set(int number, Law const& law) {
    if (number < 0 || number >= groups_)
      throw std::invalid_argument(
          detail::formatted("scree: no group %d: the law is that of %d groups, counted from 0", number, groups_));
    laws_[number] = law;
    is_set_[number] = true;
    return *this;
  }
  int groups() const { return groups_; }
  /// Returns the law of one group. A number out of range is clamped; Granular::validity() then stops the run.
  SCREE_FN Law const& of(int number) const { return laws_[Kokkos::clamp(number, 0, Kokkos::max(0, groups_ - 1))]; }

  /// Throws std::invalid_argument if there are no groups, if a group has no parameters, or if a parameter is out of
  /// range.
  void check() const {
    if (groups_ == 0)
      throw std::invalid_argument("scree: ByGroup has no groups: make it from those that the solver is made from");
    for (int k = 0; k < groups_; ++k) {
      if (!is_set_[k])
        throw std::invalid_argument(
            detail::formatted("scree: group %d of ByGroup has no law: call set(%d, law)", k, k));
      check_group(k);
    }
  }

  /// Returns the largest speed of sound of all groups, m/s, for a law of constant stiffness.
  double largest_sound_speed() const requires ConstantStiffness<Law> {
    double largest = 0;
    for (int k = 0; k < groups_; ++k) largest = std::max(largest, double(laws_[k].sound_speed()));
    return largest;
  }
  template <class Point>
  SCREE_FN double density(Point const& point) const {
    return of(point[fields::group]).density();
  }
  template <class Real, class Point>
  SCREE_FN Real bulk_modulus(StressTensor<Real> const& sigma, Point const& point) const {
    return bulk_modulus_at(of(point[fields::group]), sigma, point);
  }
  template <class Real, class Point>
  SCREE_FN Real sound_speed(StressTensor<Real> const& sigma, Point const& point) const {
    return sound_speed_at(of(point[fields::group]), sigma, point);
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return of(point[fields::group]).stress_rate(sigma, L, point);
  }
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L, Point const& point,
                             Rates& rates) const requires EvolvesHistory<Law> {
    of(point[fields::group]).history_rate(sigma, L, point, rates);
  }
  /// Returns $\sqrt{J_2}$ (Pa) at yield in plane shear at a pressure p (Pa), by the law of the group of a point.
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return of(point[fields::group]).shear_strength(p, point);
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    return of(point[fields::group]).admissible(trial, point, memory);
  }

 private:
  void check_group(int number) const {
    try {
      check_settings_of(laws_[number]);
      detail::check_response(laws_[number]);
    } catch (std::invalid_argument const& error) {
      throw std::invalid_argument(detail::formatted("%s (group %d of ByGroup)", error.what(), number));
    }
  }

  Law laws_[Capacity] = {};
  bool is_set_[Capacity] = {};
  int groups_ = 0;
};

}  // namespace scree
