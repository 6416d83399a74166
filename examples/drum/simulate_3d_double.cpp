// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "drum.hpp"

template int drum::simulate<3, double>(scree::app::Run<drum::Options> const&);
