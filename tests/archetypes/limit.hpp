// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/passes/limit.hpp>
#include <scree/passes/validity.hpp>

namespace scree::test::archetypes {

/// A function of one particle, for limits of the step and for bounds.
struct Measure {
  using reads = Fields<Concentration>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    return double(i[fields::concentration]);
  }
};
inline auto limits() {
  return std::tuple(limit("constant", 0.1), limit("state", Measure{}, [](double C) { return 0.2 / C; }));
}
inline auto bounds() { return std::tuple(bound("concentration (1)", Measure{}, 2, "start with less")); }
static_assert(detail::are_limits<decltype(limits())>);

}  // namespace scree::test::archetypes
