// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the law in ByGroup needs density\(\)
#include <scree/granular/granular.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/mixture_density.hpp>

#ifdef FIXED
using Sand = scree::MuOfI<>;
#else
using Sand = scree::MixtureDensity<scree::MuOfI<>, 2>;
#endif

scree::ByGroup<Sand> const law{};
