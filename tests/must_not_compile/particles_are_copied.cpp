// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a copy would share the fields
// not brief: a function that is deleted gets its sentence in the note on where it is declared, not in the error
#include <scree/fields/particles.hpp>
#include <scree/fields/standard.hpp>

struct P {
  static constexpr int dim = 2;
  using real = double;
  using space = Kokkos::DefaultHostExecutionSpace;
};
using Grains = scree::Particles<P, scree::Fields<scree::Mass>>;

int size_of(Grains const& grains) {
#ifdef FIXED
  Grains const& other = grains;
#else
  Grains other = grains;
#endif
  return other.size();
}
