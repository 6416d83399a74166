// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/section.hpp>

namespace scree::test::archetypes {

/// A tenth stronger in compression of one axis than in plane shear, and a tenth weaker in extension.
struct Section {
  template <class Real>
  SCREE_FN Real ratio(Real k, Real cosine) const {
    return k * (1 + cosine / 10);
  }
  template <class Real>
  SCREE_FN Real least_ratio(Real) const {
    return 0;
  }
};
static_assert(YieldSection<Section>);

}  // namespace scree::test::archetypes
