// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "drum.hpp"

template int drum::simulate<2, float>(scree::app::Run<drum::Options> const&);
