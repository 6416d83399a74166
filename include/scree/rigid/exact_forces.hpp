// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/exact_sum.hpp"
#include "forces.hpp"

#include <cstddef>
#include <vector>

// Force and moment on rigid bodies as exact sums, which depend neither on the order of the particles in memory nor on
// the domain decomposition.
namespace scree::detail {

template <class P>
struct WriteLoads {
  LoadOfParticle<P> of_particle;
  Span<double> numbers;
  SCREE_FN void operator()(int k) const {
    auto const load = of_particle(k);
    load.write(&numbers(k * load.count));
  }
};

/// Stores the sums computed on the host in the states of the bodies.
template <class P>
struct StoreLoads {
  Span<RigidLoad<P::dim> const> loads;
  StoreLoad<P> store;
  SCREE_FN void operator()(int body) const { store(body, loads(body)); }
};

/// Computes the same loads as RigidSums, with exact sums. The particles of a body may be in any order and on any rank;
/// the host of each rank sums over the particles of the rank.
template <class P>
class ExactRigidSums {
  using Load = RigidLoad<P::dim>;

 public:
  ExactRigidSums() = default;
  ExactRigidSums(typename P::space const& space, std::vector<int> const& /*groups*/, int bodies) {
    loads_ = Array<P, Load>(space, "scree::rigid_loads", std::size_t(bodies));
  }
  template <class... Of, class States>
  void run(WholeBody<Of...> const& whole, States const& states) {
    using namespace fields;
    auto const& body = whole.here();
    auto const& space = body.space();
    reserve(space, numbers_, "scree::rigid_loads", std::size_t(body.size()) * of_each);
    for_each_index(space, "scree::rigid_loads", 0, body.size(),
                   WriteLoads<P>{{body.select(SummedOfParticle{}), states.column(rigid_centre)}, numbers_});
    auto const numbers = scree::values_of(numbers_.part(0, body.size() * Load::count));
    auto const totals = whole.sum(sums_of(numbers, body.to_host(group), std::size_t(states.size())));
    std::vector<Load> loads;
    for (std::size_t k = 0; k < totals.size(); k += of_each) loads.push_back(Load::of(totals.data() + k));
    copy_into(loads_, loads);
    for_each_index(space, "scree::rigid_forces", 0, states.size(),
                   StoreLoads<P>{loads_, {states.select(SummedOfBody{})}});
  }

 private:
  static constexpr std::size_t of_each = Load::count;

  static std::vector<ExactSum> sums_of(std::vector<double> const& numbers, std::vector<int> const& groups,
                                       std::size_t bodies) {
    std::vector<ExactSum> sums(bodies * of_each);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      sums[std::size_t(groups[k / of_each]) * of_each + k % of_each] += numbers[k];
    return sums;
  }

  Array<P, double> numbers_;  // load components of the particles
  Array<P, Load> loads_;      // of bodies
};

}  // namespace scree::detail
