// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "terrain/height_field.hpp"
#include "terrain/profile.hpp"
#include "terrain/raster.hpp"
#include "terrain/release.hpp"
