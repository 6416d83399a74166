// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "motion/oscillating_shear.hpp"
#include "segregation/conservative.hpp"
#include "segregation/constant_closure.hpp"
#include "segregation/hybrid.hpp"
#include "segregation/shear_rate_closure.hpp"
#include "setup/lattice.hpp"
#include "solver/solver.hpp"
#include "surface/detect.hpp"
