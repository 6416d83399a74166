// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/interrupt.hpp>

#include <support/child.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::interrupt_tests {
using scree::Interrupt;

TEST_CASE("Ctrl-C and what a scheduler or a terminal sends raise a flag, the second Ctrl-C ends the program") {
  for (int const signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) {
    CHECK(end_of([&] {
            Interrupt const interrupt;
            if (interrupt.requested() || interrupt.exit_code() != 0) return 1;
            std::raise(signal);
            return interrupt.requested() ? interrupt.exit_code() : 2;
          }) == 128 + signal);
    for (int const second : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1})
      CHECK(end_of([&] {
              Interrupt const interrupt;
              std::raise(signal);
              std::raise(second);
              return interrupt.requested() ? interrupt.exit_code() : 3;
            }) == (signal == SIGINT && second == SIGINT ? -SIGINT : 128 + second));
    CHECK(end_of([&] {
            { Interrupt const interrupt; }
            std::raise(signal);
            return 4;
          }) == -signal);
    CHECK(end_of([&] {
            std::signal(signal, SIG_IGN);
            Interrupt const interrupt;
            std::raise(signal);
            return interrupt.requested() ? 5 : 0;
          }) == 0);
  }
}

TEST_CASE("interrupts that exist at the same time see the same signal, one after them starts without") {
  CHECK(end_of([] {
          {
            Interrupt const one;
            {
              Interrupt const another;
              std::raise(SIGTERM);
              if (!another.requested()) return 1;
            }
            Interrupt const late;
            if (!one.requested() || late.exit_code() != 128 + SIGTERM) return 2;
          }
          Interrupt const next;
          return next.requested() ? 3 : 0;
        }) == 0);
  CHECK(end_of([] {
          Interrupt const one;
          { Interrupt const another; }
          std::raise(SIGTERM);
          return one.requested() ? 4 : 5;
        }) == 4);
}

}  // namespace scree::test::interrupt_tests
