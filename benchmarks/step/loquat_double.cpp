// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "loquat.hpp"

[[maybe_unused]] static int const rows = scree::bench::add_loquat_rows<double>();
