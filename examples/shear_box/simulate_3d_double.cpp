// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "shear_box.hpp"

template void shear_box::simulate<3, double>(scree::app::Run<Options> const&);
