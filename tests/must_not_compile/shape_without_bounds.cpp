// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is not a Shape: it needs
#include <scree/setup/lattice.hpp>

struct Blob {
  static constexpr int dim = 2;
  double signed_distance(scree::Vec<2, double> const& x) const { return x.norm() - 1; }
  bool contains(scree::Vec<2, double> const& x) const { return signed_distance(x) < 0; }
#ifdef FIXED
  scree::Box<2> bounds() const { return {{-1, -1}, {1, 1}}; }
#endif
};

auto const points = scree::fill_lattice(Blob{}, 0.1);
