// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/bodies.hpp"
#include "../fields/groups.hpp"
#include "../fields/standard.hpp"
#include "../formulation/explain_set.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree {
namespace detail {

/// Throws std::invalid_argument if a collection of groups and a body have different numbers of particles.
template <int Dim>
void check_number_in(Groups<Dim> const& groups, long of_body) {
  if (groups.size() != of_body)
    throw std::invalid_argument(formatted(
        "scree: these groups have %ld particles, and the body has %ld: are they its own?", groups.size(), of_body));
}

}  // namespace detail

/// Sets a field of the particles of one group from a function of their present positions (on the host); all other
/// particles keep their values. `groups` are the groups from which the body was made, or other groups of the same
/// particles in the same order. Throws std::invalid_argument if there is no such group, or if `groups` and the body
/// have different numbers of particles.
template <class Body = Material, class S, Field F, int Dim, class Function>
void set_group(S& solver, F field, Groups<Dim> const& groups, std::string const& name, Function const& function) {
  using namespace fields;
  using P = typename S::policy;
  auto const& body = solver.template body<Body>();
  using Carried = typename std::remove_cvref_t<decltype(body)>::fields;
  if constexpr (detail::explain_set<P, Body, F, Carried, value_t<P, Position>, Function>()) {
    detail::check_number_in(groups, solver.template whole<Body>().size());
    auto const range = groups.range(name);
    auto const x = body.to_host(position);
    auto const numbers = body.to_host(identity);
    auto values = body.to_host(field);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (range.contains(numbers[k])) values[k] = value_t<P, F>(function(x[k]));
    solver.template set<Body>(field, values, [](value_t<P, F> const& value) { return value; });
  }
}

}  // namespace scree
