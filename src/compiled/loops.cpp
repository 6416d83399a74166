// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/models.hpp>
#include <scree/passes/stage.hpp>

// From here on instances are made, those of systems are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include <scree/granular/granular.hpp>
