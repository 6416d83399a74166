// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/near_cells.ipp>
#include <scree/checks/packing.ipp>
#include <scree/checks/points_in_cells.ipp>
#include <scree/checks/start.ipp>
#include <scree/checks/start_faults.ipp>
#include <scree/checks/thin_walls.ipp>
#include <scree/checks/wall_view.ipp>
#include <scree/core/available_memory.ipp>
#include <scree/core/setting.ipp>
#include <scree/fields/particles.ipp>
#include <scree/laws/plausible.ipp>
#include <scree/laws/response.ipp>
#include <scree/laws/well_posedness.ipp>
#include <scree/motion/consistent.ipp>
#include <scree/passes/finite.ipp>
#include <scree/passes/time_step.ipp>
#include <scree/solver/body_at_start.ipp>
#include <scree/solver/checks.ipp>
#include <scree/solver/unset_fields.ipp>
