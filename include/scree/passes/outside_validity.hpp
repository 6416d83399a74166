// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <stdexcept>

namespace scree {

/// The exception for a run that has left the range in which its model is valid; later results would be meaningless.
struct OutsideValidity : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
