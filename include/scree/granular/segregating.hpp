// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/combined.hpp"
#include "../segregation/conservative.hpp"
#include "granular.hpp"

namespace scree {

/// A granular material of two grain sizes that segregate. The mechanics model provides the shear rate to the
/// segregation model, which provides the concentration to the law if the law reads it (Zhu et al. 2024, section 2).
/// Grains segregate along the gravity of the mechanics, because the segregation model has no gravity of its own.
template <class Mechanics, class Segregation>
using SegregatingGranular = Combined<Mechanics, Segregation>;

}  // namespace scree
