// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/matsuoka_nakai.hpp>

namespace scree::test {

/// A law whose points have a section, as Granular gives it to laws that take one.
template <class Law, YieldSection S = MatsuokaNakai>
struct InSection : Law {
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    return Law::admissible(trial, PointOfSection<Point, S>{point}, memory);
  }
};

}  // namespace scree::test
