// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular/granular.hpp"
#include "granular/segregating.hpp"
#include "granular/wall_forces.hpp"
#include "motion/motion_of_groups.hpp"
#include "motion/oscillating_shear.hpp"
#include "motion/rotation.hpp"
#include "motion/tabulated.hpp"
#include "openings/ledger.hpp"
#include "openings/regions.hpp"
#include "segregation/conservative.hpp"
#include "segregation/constant_closure.hpp"
#include "segregation/hybrid.hpp"
#include "segregation/shear_rate_closure.hpp"
#include "segregation/under_gravity.hpp"
#include "setup/setup.hpp"
#include "solver/slip.hpp"
#include "solver/solver.hpp"
#include "solver/wall_loads.hpp"
#include "surface/detect.hpp"
