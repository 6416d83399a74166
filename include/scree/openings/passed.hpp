// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

namespace scree {

/// The particles that have entered through an inlet or left through a drain.
struct Passed {
  std::string name;    ///< of the inlet or drain
  long particles = 0;  ///< their number
  double volume = 0;   ///< m^dim
};

}  // namespace scree
