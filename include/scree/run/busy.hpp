// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <atomic>
#include <memory>
#include <stdexcept>

// Checks for uses of a solver that its state does not allow.
namespace scree::detail {

/// Returns the default instance of an execution space. Throws std::logic_error unless Kokkos is initialised.
template <class Space>
Space default_instance() {
  if (!Kokkos::is_initialized())
    throw std::logic_error(
        "scree: a solver needs Kokkos, which is not initialised, or finalised already: begin main() with "
        "`Kokkos::ScopeGuard const guard(argc, argv);`");
  return Space();
}

/// A flag that is set while a solver is advancing. The flag moves with the solver, so a solver without a flag was moved
/// from.
class Busy {
 public:
  /// A guard that sets the flag as long as it exists. Its constructor throws std::logic_error if another guard has set
  /// the flag or the solver was moved from.
  class Hold {
   public:
    explicit Hold(Busy const& busy) : flag_(busy.flag()) {
      if (flag_.exchange(true))
        throw std::logic_error(
            "scree: this solver is advancing already: an observer of its run, or another thread, must not run or step "
            "it");
    }
    ~Hold() { flag_ = false; }
    Hold(Hold const&) = delete;
    Hold& operator=(Hold const&) = delete;

   private:
    std::atomic<bool>& flag_;
  };
  /// Throws std::logic_error if the solver was moved from.
  [[gnu::cold]] void check_is_here() const { flag(); }

 private:
  std::atomic<bool>& flag() const {
    if (!flag_) throw std::logic_error("scree: this solver was moved to another one, and has nothing left");
    return *flag_;
  }
  std::unique_ptr<std::atomic<bool>> flag_ = std::make_unique<std::atomic<bool>>(false);
};

}  // namespace scree::detail
