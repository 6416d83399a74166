// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

namespace scree {

/// The particles that have entered through an inlet or left through a drain.
struct Passed {
  std::string name;    ///< name of the inlet or drain
  long particles = 0;  ///< number of particles
  double volume = 0;   ///< m^dim
};

}  // namespace scree
