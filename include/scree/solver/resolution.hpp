// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {

/// The lengths of a discretisation, m: what a model may need to know to make its passes.
struct Resolution {
  double spacing = 0;           ///< initial distance of the particles
  double smoothing_length = 0;  ///< h
  double support = 0;           ///< radius of the kernel's support
};

}  // namespace scree
