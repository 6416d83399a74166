// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shapes/boolean.hpp"
#include "shapes/primitives.hpp"
#include "shapes/section.hpp"
#include "shapes/shape.hpp"
