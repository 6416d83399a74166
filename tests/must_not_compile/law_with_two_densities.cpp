// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this law has both density\(\) and density\(point\)
#include <scree/granular/granular.hpp>

struct Law : scree::Elastic {
#ifndef FIXED
  double density() const { return 1000; }
#endif
  template <class Point>
  SCREE_FN double density(Point const&) const {
    return 1000;
  }
};
struct Models : scree::GranularModels {
  using law = Law;
};

scree::Granular<Models> const physics{};
