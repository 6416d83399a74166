// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "measured_fill.hpp"
#include "mesh/mesh.hpp"
#include "mesh/placement.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/read_polygon.hpp"
