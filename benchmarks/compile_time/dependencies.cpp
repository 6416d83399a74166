// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The unit of the budget: the compile time of the dependencies alone, which every source file with scree includes.
#include <fmt/core.h>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Kokkos_Core.hpp>
