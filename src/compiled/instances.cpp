// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#define SCREE_INSTANCE template
#include <scree/setup/lattice.hpp>
#include <scree/system/instances.hpp>
