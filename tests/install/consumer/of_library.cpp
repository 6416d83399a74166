// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Uses a function that the library scree::compiled has and the headers only declare.
#include <scree/core/setting.hpp>

#ifndef SCREE_COMPILED
#error scree::compiled must define SCREE_COMPILED for its users
#endif

int main() { scree::check_setting(true, "a setting", 1, "1"); }
