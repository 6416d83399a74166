// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The unit of the budget: what every source file with scree pays before scree itself.
#include <fmt/core.h>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Kokkos_Core.hpp>
