// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

namespace scree::app {

namespace detail {
/// The complaint about a number of particles; empty: none.
std::string about_memory(double particles);
}  // namespace detail

/// Refuses, at `key`, a case of more particles than can be counted or than there is memory for.
template <class T>
void require_memory(Schema<T>& schema, std::string key, std::function<double(T const&)> particles) {
  schema.complain({std::move(key), [particles](T const& options) { return detail::about_memory(particles(options)); }});
}

}  // namespace scree::app
