// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {

/// The template arguments on which compiled loops depend: dimension, precision, kernel and execution space. All
/// formulations with the same basis share these loops, so that each further formulation compiles only its own code.
template <int Dim, class Real, class Kernel, class Space>
struct Basis {
  static constexpr int dim = Dim;
  using real = Real;
  using kernel = Kernel;
  using space = Space;
};

/// The basis of a policy class.
template <class P>
using basis_of = Basis<P::dim, typename P::real, typename P::kernel, typename P::space>;

}  // namespace scree
