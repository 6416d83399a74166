// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/models.hpp>
#include <scree/passes/stage.hpp>

#if defined(SCREE_COMPILED_WITH_AVX) != defined(__AVX__)
#error "scree::compiled must be configured anew: the flags of the compiler allow other vector instructions than before"
#endif

// From here on instances are made, those of systems are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include <scree/granular/granular.hpp>
