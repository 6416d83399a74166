// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "walk.hpp"

using P = scree::bench::BasisOf<3, double>;
[[maybe_unused]] static int const rows[] = {scree::bench::add_build_rows<P>(), scree::bench::add_walk_rows<P>()};
