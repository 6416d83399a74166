// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

/// The end of a child process that runs `action`: its exit code, or minus the number of the signal.
template <class Action>
int end_of(Action action) {
  ::pid_t const child = ::fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);  // not those of the test framework
    for (int const signal : {SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) std::signal(signal, SIG_DFL);
    std::_Exit(action());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}
