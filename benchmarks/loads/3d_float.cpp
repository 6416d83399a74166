// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "loads.hpp"

[[maybe_unused]] static int const rows = scree::bench::add_load_rows<3, float>();
