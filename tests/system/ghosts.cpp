// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::ghosts_tests {
using namespace fields;
namespace {

/// The least that a provider of ghosts is: none.
template <class P>
struct NoGhosts {
  using Settings = std::vector<Period>;
  NoGhosts(Settings const&, double, double) {}
  Settings settings() const { return {}; }
  std::string signature() const { return ""; }
  bool any() const { return false; }
  template <class Body>
  void settle(Body&) const {}
  template <class Body>
  void create(Body&) {}
  template <class Body, class List>
  void refresh(Body&, List) const {}
};
/// Periodic images that count how often they are created.
template <class P>
struct CountedImages : PeriodicImages<P> {
  using PeriodicImages<P>::PeriodicImages;
  inline static int created = 0;
  template <class Body>
  void create(Body& body) {
    ++created;
    PeriodicImages<P>::create(body);
  }
};

template <class Q>
struct Layer : Formulation<Q::dim, typename Q::real> {
  using space = typename Q::space;
  using physics = Granular<>;
};
template <class Q, template <class> class Ghosts>
struct LayerWith : Layer<Q> {
  template <class P>
  using ghosts = Ghosts<P>;
};
template <class F>
auto stresses(std::vector<Period> const& periods) {
  Granular<> physics;
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  auto solver = solver_of<F>(layer({1, 0.5}, 0.1), 0.1, physics, {}, periods);
  solver.set(velocity, [](auto const& x) { return Vec<2, typename F::real>(x[1], 0); });
  for (int k = 0; k < 60; ++k) solver.step(1);
  return std::pair(solver.material().to_host(stress), solver.neighbour_builds());
}
using Planes =
    std::tuple<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Policy<2, float, Kokkos::DefaultExecutionSpace>>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("a formulation names who provides its ghosts", "", Planes) {
  static_assert(GhostProvider<NoGhosts<basis_of<Layer<TestType>>>, basis_of<Layer<TestType>>>);
  std::vector<Period> const periods{{0, 0, 1}};
  auto const [expected, builds] = stresses<Layer<TestType>>(periods);
  using Counted = LayerWith<TestType, CountedImages>;
  auto& created = CountedImages<basis_of<Counted>>::created;
  created = 0;
  CHECK(stresses<Counted>(periods).first == expected);
  CHECK(created == 2 * builds);  // for each body
  CHECK(stresses<LayerWith<TestType, NoGhosts>>({}).first == stresses<Layer<TestType>>({}).first);
  CHECK(stresses<LayerWith<TestType, NoGhosts>>({}).first != expected);
}

}  // namespace scree::test::ghosts_tests
