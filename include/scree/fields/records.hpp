// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "particles.hpp"

#include <cstddef>
#include <vector>

// Records of individual particles on the host.
namespace scree {

/// Returns host records of the given fields, such as `records[k][velocity]`, for the owned particles of a body or for
/// the particles with given indices.
template <class Body, class... Fs, class... Numbers>
auto records_of(Body const& body, Fields<Fs...>, Numbers const&... which) {
  using P = typename Body::policy;
  static_assert(sizeof...(Numbers) < 2);
  std::size_t const count = (std::size_t(body.size()) + ... + (std::size_t(which.size()) - std::size_t(body.size())));
  std::vector<Record<P, Fields<Fs...>>> records(count);
  [[maybe_unused]] auto const fill = [&](auto field) {
    auto const values = body.to_host(field, which...);
    for (std::size_t i = 0; i < records.size(); ++i)
      static_cast<detail::Slot<P, decltype(field)>&>(records[i]).value = values[i];
  };
  (fill(Fs{}), ...);
  return records;
}

}  // namespace scree
