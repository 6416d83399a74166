// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {

/// The lengths of a discretisation, m unless said: what a model may need to know to make its passes.
struct Resolution {
  double spacing = 0;            ///< initial distance of the particles
  double smoothing_length = 0;   ///< h
  double support = 0;            ///< radius of the kernel's support
  double lattice_sum = 1;        ///< sum of V W over the initial lattice, -
  double surface_asymmetry = 1;  ///< |h sum V gradW| of a particle on a plane surface, -
  long steps = 0;                ///< taken so far
};

}  // namespace scree
