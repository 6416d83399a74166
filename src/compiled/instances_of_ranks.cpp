// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/system/instances.hpp>

// From here on instances are made, those of one rank are in instances.cpp.
#undef SCREE_INSTANCE
#define SCREE_INSTANCE template
#include <scree/distributed/instances.hpp>
