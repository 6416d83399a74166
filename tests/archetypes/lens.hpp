// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

/// Every neighbour has the concentration of the particle itself.
struct Lens {
  using provides = Fields<Concentration>;
  using reads_i = Fields<Concentration>;
  template <class I, class J>
  SCREE_FN auto operator()(Concentration, I const& i, J const&) const {
    return i[fields::concentration];
  }
};

}  // namespace scree::test::archetypes
