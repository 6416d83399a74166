// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backends.hpp"

#include <scree/core/types.hpp>
#include <scree/kernels/wendland_c2.hpp>

#include <limits>
#include <tuple>
#include <utility>

// Minimal policies for fields, searches, loops and terms, without a formulation.
namespace scree::test {

template <int Dim, class Real, class Space, class Kernel = WendlandC2>
struct Policy {
  static constexpr int dim = Dim;
  using real = Real;
  using space = Space;
  using kernel = Kernel;
};

namespace policy_lists {
template <class... Lists>
using joined = decltype(std::tuple_cat(std::declval<Lists>()...));
template <class Spaces>
struct policies;
template <class... Spaces>
struct policies<std::tuple<Spaces...>> {
  using in_double = joined<std::tuple<Policy<2, double, Spaces>, Policy<3, double, Spaces>>...>;
  using in_float = joined<std::tuple<Policy<2, float, Spaces>, Policy<3, float, Spaces>>...>;
};
}  // namespace policy_lists

/// 2D and 3D on every backend, in double, and in both precisions: for TEMPLATE_LIST_TEST_CASE.
using DoublePolicies = policy_lists::policies<Backends>::in_double;
using Policies = policy_lists::joined<DoublePolicies, policy_lists::policies<Backends>::in_float>;

/// A policy on another execution space.
template <class P, class Space>
using OnSpace = Policy<P::dim, typename P::real, Space, typename P::kernel>;

/// A number of units in the last place of one, in the precision of a policy.
template <class P>
constexpr double ulps(double number) {
  return number * double(std::numeric_limits<typename P::real>::epsilon());
}

}  // namespace scree::test
