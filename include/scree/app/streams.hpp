// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree::app {

/// To be called first in main(). Standard streams that are closed become /dev/null: otherwise the next file that is
/// opened would take their place, and messages would go into it. A write to a pipe without a reader, or to a file at
/// its size limit, fails with a reason and does not end the program.
void guard_streams();

}  // namespace scree::app
