// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "pass.hpp"

namespace scree {
namespace detail {
/// Whether a pass changes no fields but those in its `writes`: its loop can write no others.
template <class Pass>
inline constexpr bool changes_only_writes = false;
template <class... Ts>
inline constexpr bool changes_only_writes<PairPass<Ts...>> = true;
template <class... Ts>
inline constexpr bool changes_only_writes<PointPass<Ts...>> = true;
template <class Pass>
inline constexpr bool changes_only_writes<OnlyIf<Pass>> = changes_only_writes<Pass>;

/// Only its passes change fields during its lifetime. Ghosts receive the fields that these changed, and no others.
template <class Sys>
class PassesOf {
  static constexpr bool announces = Sys::tracks_changes;

 public:
  explicit PassesOf(Sys& system) : system_(system) {
    if constexpr (announces) system.announces_changes(true);
  }
  PassesOf(PassesOf const&) = delete;
  PassesOf& operator=(PassesOf const&) = delete;
  ~PassesOf() {
    if constexpr (announces) system_.announces_changes(false);
  }
  template <class Pass>
  void run(Pass const& pass) const {
    constexpr bool says_all = changes_only_writes<Pass>;
    if constexpr (announces && !says_all) system_.announces_changes(false);
    pass.run(system_);
    if constexpr (announces && !says_all) system_.announces_changes(true);
    if constexpr (announces && says_all)
      for_each_body(typename Sys::bodies{},
                    [&]<class Body>() { system_.template fields_changed<Body>(writes_of_pass<Body, Pass>{}); });
  }

 private:
  Sys& system_;
};
}  // namespace detail

/// Runs a list of passes in order.
template <class Sys, detail::AnyTuple Passes>
void run_passes(Sys& system, Passes const& passes) {
  detail::PassesOf<Sys> const list(system);
  detail::with_values([&](auto const&... each) { (list.run(each), ...); }, passes);
}

}  // namespace scree
