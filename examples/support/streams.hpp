// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace support {

/// To be called first in main(). Standard streams that are closed become /dev/null: else the next file that is opened
/// would take their place, and messages would go into it. A pipe that nobody reads and a file that has reached its
/// limit make a write fail, with a reason, rather than end the program.
inline void guard_streams() {
  for (int number = 0; number <= 2; ++number)
    if (::fcntl(number, F_GETFD) == -1) static_cast<void>(::open("/dev/null", O_RDWR));  // takes the lowest free number
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace support
