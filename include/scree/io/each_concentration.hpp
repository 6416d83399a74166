// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"
#include "derived_field.hpp"

#include <string_view>
#include <utility>

namespace scree {
namespace detail {
/// The name of the concentration of species K: "concentration 1" and so on.
template <int K>
inline constexpr char name_of_concentration[] = {'c', 'o', 'n', 'c', 'e', 'n', 't',          'r',
                                                 'a', 't', 'i', 'o', 'n', ' ', char('0' + K)};
}  // namespace detail

/// The concentration of species K (1 to N) for output: writers have no array type for the concentrations of all
/// species.
template <int N, int K>
struct ConcentrationOf {
  static_assert(K >= 1 && K <= N && K <= 9, "species count from 1 to their number, 9 at most");
  static constexpr std::string_view name{detail::name_of_concentration<K>, sizeof(detail::name_of_concentration<K>)};
  static constexpr std::string_view unit = "1";
  template <int Dim, class Real>
  using value = Real;
  using reads = Fields<Concentrations<N>>;
  /// Returns the concentration of species K in a particle.
  template <class I>
  static auto of(I const& i, Resolution const&) {
    return std::remove_cvref_t<decltype(i[fields::concentrations<N>][0])>(i[fields::concentrations<N>][K - 1]);
  }
};

namespace detail {
template <int N, int... K>
Fields<ConcentrationOf<N, K + 1>...> each_concentration(std::integer_sequence<int, K...>);
}  // namespace detail

/// The concentrations of N species as a list of fields.
template <int N>
using EachConcentration = decltype(detail::each_concentration<N>(std::make_integer_sequence<int, N>{}));

}  // namespace scree
