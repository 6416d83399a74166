// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/cells.ipp>
#include <scree/setup/rings.ipp>
#include <scree/setup/shapes/polygon.ipp>
#include <scree/setup/shapes/primitives.ipp>
#include <scree/setup/walls.ipp>
