// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <Kokkos_Core.hpp>
#include <catch2/catch_session.hpp>

#include <optional>

// Kokkos starts only when tests run: listing them (ctest does at its start) must work on a machine without the device.
int main(int argc, char** argv) {
  Catch::Session session;
  if (int const error = session.applyCommandLine(argc, argv); error != 0) return error;
  auto const& config = session.configData();
  bool const only_lists = config.listTests || config.listTags || config.listReporters || config.listListeners;
  std::optional<Kokkos::ScopeGuard> kokkos;
  if (!only_lists && !config.showHelp) kokkos.emplace();
  return session.run();
}
