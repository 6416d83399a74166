// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree::app {

/// To be called first in main(). Standard streams that are closed become /dev/null: otherwise the next file that is
/// opened would take their place, and messages would go into it. A pipe that nobody reads and a file that has reached
/// its limit make a write fail, with a reason, rather than end the program.
void guard_streams();

}  // namespace scree::app
