// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/kept.hpp"
#include "../support/timing.hpp"
#include "random_fields.hpp"

#include <scree/neighbours/verlet_list.hpp>
#include <scree/pairs/for_each_pair.hpp>

#include <tuple>

// Rows of one pair loop over one body with the default search.
namespace scree::bench {

struct NeighbourCount : Integer<"neighbours", "1"> {};
struct CountNeighbours {
  using reads = Fields<>;
  using adds = Fields<NeighbourCount>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const&, IJ const&, S& sum) const {
    sum[NeighbourCount{}] += 1;
  }
};

/// A body of particles that sums terms over itself.
template <class P, class... Terms>
struct SelfSum {
  using reads = Merge<reads_of<Terms>..., reads_i_of<Terms>...>;
  using fields = Merge<Fields<Position, Volume, NeighbourCount>, reads, adds_of<Terms>...>;
  kernel_of<P> kernel;
  Particles<P, fields> body;
  VerletList<P> search;
  std::tuple<Terms...> terms;
  double pairs;  ///< within the support

  SelfSum(Cloud<P::dim> const& cloud, std::tuple<Terms...> const& all)
      : kernel(cloud.smoothing_length), search(double(kernel.radius())), terms(all) {
    using namespace fields;
    populate(body, cloud, Without<reads, Fields<Position, Volume>>{});
    search.update(body[position], body[position]);
    pairs = count_neighbours();
  }
  void run() const {
    PairLoopOptions<P> const options{"scree::bench::sum", kernel};
    std::apply([&](Terms const&... each) { for_each_pair(options, body, from(body, search, each...)); }, terms);
  }

 private:
  double count_neighbours() const {
    PairLoopOptions<P> const options{"scree::bench::count", kernel};
    for_each_pair(options, body, from(body, search, CountNeighbours{}));
    double sum = 0;
    for (int const each : body.to_host(NeighbourCount{})) sum += each;
    return sum;
  }
};

template <class P, class... Terms>
void add_sum_row(std::string const& name, int particles, double smoothing, int batch,
                 std::tuple<Terms...> const& terms) {
  add_row(name, [=](benchmark::State& state) {
    auto& sum = kept(name, [&] { return SelfSum<P, Terms...>(cloud_of<P::dim>(particles, smoothing), terms); });
    time(state, batch, [&] { sum.run(); });
    count_pairs(state, sum.body.size(), sum.pairs);
  });
}

/// A row for each size. Where loops are short, a host that waits for each loop sees other times (`/alone`).
template <class P, class... Terms>
void add_sum_rows(std::string const& what, double smoothing, Terms const&... terms) {
  for (int const particles : small_sizes()) {
    auto const name = fmt::format("pairs/{}/{}/h:{}/particles:{}", what, basis_name<P>(), smoothing, particles);
    add_sum_row<P>(name, particles, smoothing, together, std::tuple(terms...));
    if (together > alone && particles == small_sizes().front())
      add_sum_row<P>(name + "/alone", particles, smoothing, alone, std::tuple(terms...));
  }
}

}  // namespace scree::bench
