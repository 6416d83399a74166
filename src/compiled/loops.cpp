// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/models.hpp>
#include <scree/passes/limit.hpp>
#include <scree/passes/stage.hpp>

#ifdef __AVX__
#error "loops.cpp of scree::compiled must be compiled without AVX: with -mno-avx"
#endif

// From here on instances are made. Those of systems are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include <scree/granular/granular.hpp>
#include <scree/segregation/conservative.hpp>
