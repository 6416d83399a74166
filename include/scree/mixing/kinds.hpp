// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/list.hpp"
#include "../fields/record.hpp"
#include "../fields/species.hpp"
#include "../fields/standard.hpp"

#include <concepts>
#include <type_traits>

// The kinds of grains whose mixing is measured, and their shares in a particle.
namespace scree {

/// Whether K is a function of one particle that returns the share of each kind of grains in its volume. The shares add
/// up to 1. The members of K are:
///   kinds     the number of kinds, an int of 2 or more
///   reads     a list of fields
///   operator()(i)  returns a Vec<kinds, double>
template <class K, class P>
concept GrainKinds = requires(K const& kinds, Record<P, reads_of<K>> const& i) {
  requires K::kinds >= 2;
  { kinds(i) } -> std::same_as<Vec<K::kinds, double>>;
};

/// Small and large grains, whose shares follow from the concentration of small grains.
struct TwoSizes {
  static constexpr int kinds = 2;
  using reads = Fields<Concentration>;
  template <class I>
  SCREE_FN Vec<2, double> operator()(I const& i) const {
    double const C = double(i[fields::concentration]);
    return {C, 1 - C};
  }
};
/// The species of a mixture.
template <int N>
struct SpeciesOf {
  static constexpr int kinds = N;
  using reads = Fields<Concentrations<N>>;
  template <class I>
  SCREE_FN Vec<N, double> operator()(I const& i) const {
    Vec<N, double> C;
    for (int k = 0; k < N; ++k) C[k] = double(i[fields::concentrations<N>][k]);
    return C;
  }
};
/// The particles of one group and all other particles: grains that differ only in colour. Groups::number() returns the
/// number of a group.
struct MarkedGroup {
  int number = 0;  ///< of the marked group
  static constexpr int kinds = 2;
  using reads = Fields<Group>;
  template <class I>
  SCREE_FN Vec<2, double> operator()(I const& i) const {
    double const marked = i[fields::group] == number ? 1 : 0;
    return {marked, 1 - marked};
  }
};

namespace detail {

struct NoKinds {};

template <class F>
struct kinds_of_field {
  using type = NoKinds;
};
template <>
struct kinds_of_field<Concentration> {
  using type = TwoSizes;
};
template <int N>
struct kinds_of_field<Concentrations<N>> {
  using type = SpeciesOf<N>;
};

template <class List>
struct kinds_among {
  using type = NoKinds;
};
template <class F, class... Fs>
struct kinds_among<Fields<F, Fs...>> {
  using here = typename kinds_of_field<F>::type;
  using type = typename std::conditional_t<std::is_same_v<here, NoKinds>, kinds_among<Fields<Fs...>>,
                                           std::type_identity<here>>::type;
};

template <class S>
using material_of = std::remove_cvref_t<decltype(std::declval<S const&>().material())>;

}  // namespace detail

/// The kinds of grains in the material of a solver: TwoSizes or SpeciesOf<N>; detail::NoKinds if the material carries
/// no concentration.
template <class S>
using kinds_in = typename detail::kinds_among<typename detail::material_of<S>::fields>::type;

namespace detail {

/// Whether a solver has these kinds of grains; if not, the first compiler error names the missing member or field.
template <class Kinds, class S>
constexpr bool explain_kinds() {
  using P = typename S::policy;
  static_assert(!std::is_same_v<Kinds, NoKinds>,
                "the material carries no concentration whose mixing could be measured: name a model of segregation in "
                "the physics, list Concentration in `carries` of the formulation, or give the kinds of grains, such as "
                "MarkedGroup{1}");
  if constexpr (std::is_same_v<Kinds, NoKinds>) {
    return false;
  } else {
    static_assert(GrainKinds<Kinds, P>,
                  "these are no GrainKinds: they need their number, `static constexpr int kinds = 2`, a list `reads`, "
                  "and operator()(i) const, which returns a Vec<kinds, double>");
    if constexpr (GrainKinds<Kinds, P>) {
      constexpr bool carried = std::is_same_v<Without<reads_of<Kinds>, typename material_of<S>::fields>, Fields<>>;
      static_assert(carried,
                    "the material does not carry a field that these kinds of grains read: list it in `carries` of the "
                    "formulation");
      return carried;
    } else {
      return false;
    }
  }
}

/// The volume of a particle and the volume of each kind of grains in it.
template <class Kinds>
struct VolumesOfKinds {
  static constexpr int count = Kinds::kinds + 1;
  using reads = Merge<Fields<Volume>, reads_of<Kinds>>;
  Kinds kinds;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    double const V = double(i[fields::volume]);
    auto const C = kinds(i);
    Vec<count, double> terms;
    terms[0] = V;
    for (int k = 0; k < Kinds::kinds; ++k) terms[k + 1] = V * C[k];
    return terms;
  }
};
}  // namespace detail
}  // namespace scree
