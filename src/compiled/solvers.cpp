// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

#ifdef __AVX__
#error "solvers.cpp of scree::compiled must be compiled without AVX: with -mno-avx"
#endif

#define SCREE_SOLVERS_HERE(P) SCREE_SOLVERS(template, P)
SCREE_FOR_DEFAULT_SOLVERS(SCREE_SOLVERS_HERE)
