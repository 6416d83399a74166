// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular/granular.hpp"
#include "granular/segregating.hpp"
#include "motion/oscillating_shear.hpp"
#include "motion/rotation.hpp"
#include "segregation/conservative.hpp"
#include "segregation/constant_closure.hpp"
#include "segregation/hybrid.hpp"
#include "segregation/shear_rate_closure.hpp"
#include "segregation/under_gravity.hpp"
#include "setup/setup.hpp"
#include "solver/solver.hpp"
#include "surface/detect.hpp"
