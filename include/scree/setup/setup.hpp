// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/groups.hpp"
#include "../fields/shared_points.hpp"
#include "geostatic.hpp"
#include "hexagonal.hpp"
#include "lattice.hpp"
#include "rings.hpp"
#include "shapes.hpp"
#include "shapes/polygon.hpp"
#include "walls.hpp"
