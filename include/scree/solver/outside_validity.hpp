// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <stdexcept>

namespace scree {

/// A run has left the range in which its model holds: what it would give from there on means nothing.
struct OutsideValidity : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
