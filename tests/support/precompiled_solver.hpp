// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Headers of the library for tests with a solver, compiled once; see precompiled.hpp.
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>
