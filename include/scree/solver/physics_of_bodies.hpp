// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/physics_of_bodies.hpp"  // its place; programs for 0.1.0 include it from here
