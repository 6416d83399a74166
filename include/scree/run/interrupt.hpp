// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <mutex>

namespace scree {

/// A guard that catches signals. As long as it exists, Ctrl-C, SIGTERM, SIGHUP (a closed terminal), SIGXCPU (a time
/// limit) and SIGUSR1 (a warning that schedulers can send before their limit) only set a flag, so that a run can write
/// a checkpoint and stop. A second Ctrl-C has its usual effect; repetitions of the other signals have none, because job
/// schedulers and timeout(1) send several. Signals that were ignored before (as in a background job) remain ignored.
/// Guards that exist at the same time, for instance in several runs of one program, share one flag, which the first
/// guard clears.
class Interrupt {
 public:
  /// Begins to catch signals.
  Interrupt() {
    std::scoped_lock const lock(changing);
    if (objects++ > 0) return;
    received = 0;
    struct sigaction catching = {};
    catching.sa_handler = [](int signal) {
      received = signal;
      if (signal == SIGINT) sigaction(SIGINT, &before[0], nullptr);
    };
    catching.sa_flags = SA_RESTART;  // output in progress is completed
    sigemptyset(&catching.sa_mask);
    for (int const signal : signals) sigaddset(&catching.sa_mask, signal);
    for (std::size_t k = 0; k < signals.size(); ++k) {
      sigaction(signals[k], nullptr, &before[k]);
      if (before[k].sa_handler != SIG_IGN) sigaction(signals[k], &catching, nullptr);
    }
  }
  Interrupt(Interrupt const&) = delete;
  Interrupt& operator=(Interrupt const&) = delete;
  ~Interrupt() {
    std::scoped_lock const lock(changing);
    if (--objects == 0) give_back();
  }

  /// Whether a signal has asked the run to stop.
  bool requested() const { return received != 0; }
  /// Returns the exit code that a shell expects after a signal; 0 if there was none.
  int exit_code() const { return requested() ? 128 + received : 0; }

 private:
  static constexpr std::array<int, 5> signals = {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1};

  // A signal handler can access only static variables; sigaction() is among the few functions that it may call.
  static_assert(std::atomic<int>::is_always_lock_free, "a handler of signals can set a lock-free number only");
  static inline std::atomic<int> received = 0;
  static inline std::array<struct sigaction, signals.size()> before = {};
  static inline int objects = 0;
  static inline std::mutex changing;

  static void give_back() {
    for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &before[k], nullptr);
  }
};

}  // namespace scree
