// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree::app {

/// Protects the standard streams; main() must call this first. Closed standard streams become /dev/null: otherwise the
/// next file that is opened would take their place, and messages would be written to it. A write to a pipe without a
/// reader, or to a file at its size limit, then fails with a reason and does not end the program.
void guard_streams();

}  // namespace scree::app
