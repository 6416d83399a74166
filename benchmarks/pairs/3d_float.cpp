// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular_sweep.hpp"
#include "motion.hpp"
#include "terms.hpp"

using P = scree::bench::BasisOf<3, float>;
[[maybe_unused]] static int const rows[] = {scree::bench::add_motion_rows<P>(), scree::bench::add_granular_rows<P>(),
                                            scree::bench::add_term_rows<P>()};
