// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../fields/particles.hpp"
#include "../fields/standard.hpp"
#include "../rigid/state.hpp"
#include "by_identity.hpp"
#include "shared_memory.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

// Functions that give every rank the state of the whole case. All ranks call them together.
namespace scree {
namespace detail {

template <class T>
std::uint64_t add_to_hash(std::uint64_t hash, std::vector<T> const& values) {
  auto const* const bytes = reinterpret_cast<unsigned char const*>(values.data());
  for (std::size_t k = 0; k < values.size() * sizeof(T); ++k) hash = (hash ^ bytes[k]) * 0x100000001b3;
  return hash;
}

/// Returns an object that sorts values of a body by particle identity. The case of the solver need not be divided among
/// ranks.
template <class Body, class S>
auto order_by_identity(S const& solver) {
  auto const& body = solver.template body<Body>();
  if constexpr (requires { solver.ranks().team(); })
    return solver.ranks().order_of(body);
  else
    return ByIdentity<typename S::Space>(team_of_one<typename S::Space>(), body.to_host(fields::identity), false);
}

}  // namespace detail

/// Returns a field of all particles of a body, sorted by identity. The case of the solver need not be divided among
/// ranks.
template <BodyTag Body, class S, Field F>
auto gathered(S const& solver, F field) {
  return detail::order_by_identity<Body>(solver).of(solver.template body<Body>().to_host(field));
}

namespace detail {
template <class Space>
std::uint64_t add_columns_to_hash(std::uint64_t hash, ByIdentity<Space> const& order,
                                  UntypedParticles<Space> const& columns, ColumnNumbers which) {
  using Word = UntypedColumn::Word;
  for (std::size_t const column : which) {
    std::size_t const words = columns.bytes_of(column) / sizeof(Word);
    std::vector<Word> values(std::size_t(columns.size()) * words);
    columns.to_host(column, values.data());
    hash = add_to_hash(hash, order.of(std::move(values), words));
  }
  return hash;
}
template <class Body, class S, class List>
std::uint64_t add_fields_to_hash(std::uint64_t hash, S const& solver, List fields) {
  auto const& body = solver.template body<Body>();
  return add_columns_to_hash(hash, order_by_identity<Body>(solver), body.columns(), body.numbers_of(fields));
}
}  // namespace detail

/// Returns a hash of the time and of all fields of the particles of all bodies, which very probably differs if a single
/// bit of them differs. The hash depends neither on the ranks nor on the order of the particles in memory.
template <class S>
std::uint64_t state_hash(S const& solver) {
  std::uint64_t hash = detail::add_to_hash(0xcbf29ce484222325, std::vector<double>{solver.time()});
  detail::for_each_body(typename S::policy::bodies{}, [&]<class Body>() {
    using Particles = std::remove_cvref_t<decltype(solver.template body<Body>())>;
    hash = detail::add_fields_to_hash<Body>(hash, solver, typename Particles::fields{});
  });
  if constexpr (S::has_rigid_bodies)
    hash = detail::add_fields_to_hash<RigidStates>(hash, solver, detail::RigidFields{});
  return hash;
}

}  // namespace scree
