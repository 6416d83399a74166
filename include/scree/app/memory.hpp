// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

namespace scree::app {

namespace detail {
/// Returns the message about a number of particles; empty: none.
std::string about_memory(double particles);
}  // namespace detail

/// Rejects, at `key`, a case with more particles than can be counted or fit into memory.
template <class T>
void require_memory(Schema<T>& schema, std::string key, std::function<double(T const&)> particles) {
  schema.complain({std::move(key), [particles](T const& options) { return detail::about_memory(particles(options)); }});
}

}  // namespace scree::app
