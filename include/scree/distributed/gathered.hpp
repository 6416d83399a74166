// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../solver/bodies.hpp"
#include "team.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

// The state of a case, on each of its parts. All parts call these functions together.
namespace scree {
namespace detail {

/// Values of all parts, those of part 0 first.
template <class Space, class T>
std::vector<T> joined_values(Team<Space> const& team, std::vector<T> values) {
  auto const sizes = team.gather(std::int64_t(values.size()));
  auto const most = static_cast<std::size_t>(*std::max_element(sizes.begin(), sizes.end()));
  values.resize(most);
  auto const padded = team.gather(values);
  std::vector<T> all;
  for (std::size_t q = 0; q < sizes.size(); ++q) {
    auto const first = padded.begin() + static_cast<std::ptrdiff_t>(q * most);
    all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(sizes[q]));
  }
  return all;
}

template <class T>
std::uint64_t add_to_hash(std::uint64_t hash, std::vector<T> const& values) {
  std::vector<unsigned char> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), static_cast<void const*>(values.data()), bytes.size());
  for (unsigned char const byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  return hash;
}

}  // namespace detail

/// A field of all particles of a body, by identity. The solver may be one of a case without parts.
template <BodyTag Body, class S, Field F>
auto gathered(S const& solver, F field) {
  auto const all = [&](auto const& here) {
    if constexpr (requires { solver.parts().team(); })
      return detail::joined_values(solver.parts().team(), here);
    else
      return here;
  };
  auto const& body = solver.template body<Body>();
  auto const numbers = all(body.to_host(identity));
  auto const values = all(body.to_host(field));
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  auto sorted = values;
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
  return sorted;
}

namespace detail {
template <class Body, class S, class... Fs>
std::uint64_t add_fields_to_hash(std::uint64_t hash, S const& solver, Fields<Fs...>) {
  ((hash = add_to_hash(hash, gathered<Body>(solver, Fs{}))), ...);
  return hash;
}
}  // namespace detail

/// A number that differs, in all likelihood, if one bit of a field of a particle of any body or of the time differs. It
/// depends neither on the parts nor on the order of the particles in memory.
template <class S>
std::uint64_t state_hash(S const& solver) {
  std::uint64_t hash = detail::add_to_hash(0xcbf29ce484222325, std::vector<double>{solver.time()});
  detail::for_each_body(typename S::policy::bodies{}, [&]<class Body>() {
    using Particles = std::remove_cvref_t<decltype(solver.template body<Body>())>;
    hash = detail::add_fields_to_hash<Body>(hash, solver, typename Particles::fields{});
  });
  return hash;
}

}  // namespace scree
