// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "geostatic.hpp"
#include "groups.hpp"
#include "hexagonal.hpp"
#include "lattice.hpp"
#include "rings.hpp"
#include "shapes.hpp"
#include "shapes/polygon.hpp"
#include "shared_points.hpp"
#include "walls.hpp"
