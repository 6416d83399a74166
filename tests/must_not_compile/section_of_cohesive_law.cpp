// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the law in MatsuokaNakai needs a function shear_strength
#include <scree/granular/granular.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/matsuoka_nakai.hpp>

#ifdef FIXED
using Soil = scree::MuOfI<>;
#else
using Soil = scree::DruckerPrager;
#endif

scree::MatsuokaNakai<Soil> const law{};
