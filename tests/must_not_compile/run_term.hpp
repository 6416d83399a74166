// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Runs the term `Sum` of the including file over a body with itself.

#include <scree/fields/particles.hpp>
#include <scree/kernels/wendland_c2.hpp>
#include <scree/neighbours/brute_force.hpp>
#include <scree/pairs/for_each_pair.hpp>

struct P {
  static constexpr int dim = 2;
  using real = double;
  using space = Kokkos::DefaultHostExecutionSpace;
  using kernel = scree::WendlandC2;
};

void run(scree::Particles<P, scree::Fields<scree::Position, scree::Mass, scree::Volume, scree::Density>> const& body,
         scree::BruteForce<P> const& search) {
  scree::PairLoopOptions<P> const options{"sum", scree::kernel_of<P>(1)};
  scree::for_each_pair(options, body, scree::from(body, search, Sum{}));
}
