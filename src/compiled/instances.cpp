// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#define SCREE_INSTANCE template
#include <scree/checks/near_cells.hpp>
#include <scree/checks/start.hpp>
#include <scree/checks/start_in_space.hpp>
#include <scree/checks/thin_walls_in_space.hpp>
#include <scree/granular/rigid_rotation.hpp>
#include <scree/granular/viscous_share.hpp>
#include <scree/io/point_columns.hpp>
#include <scree/motion/instances.hpp>
#include <scree/passes/finite.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/shapes/primitives.hpp>
#include <scree/snapshots/snapshot_of.hpp>
#include <scree/surface/cell_types.hpp>
#include <scree/system/instances.hpp>
