// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ranks.hpp"

namespace {
struct ThisFile {};
}  // namespace

bool cases::allowed_in_whole_cases() { return cases::allows_two<ThisFile>(); }
