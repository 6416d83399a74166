// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/kernels/cubic_spline.hpp>
#include <scree/kernels/gaussian.hpp>
#include <scree/kernels/quartic_spline.hpp>
#include <scree/kernels/quintic_spline.hpp>
#include <scree/kernels/wendland_c2.hpp>
#include <scree/kernels/wendland_c4.hpp>
#include <scree/kernels/wendland_c6.hpp>

#include <tuple>

namespace scree::test {

/// Every kernel: add a new one here to test it.
using Kernels = std::tuple<CubicSpline, Gaussian, QuarticSpline, QuinticSpline, WendlandC2, WendlandC4, WendlandC6>;

}  // namespace scree::test
