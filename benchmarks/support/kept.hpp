// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <string>

namespace scree::bench {
namespace detail {
struct Slot {
  std::string row;
  std::shared_ptr<void> state;
};
inline Slot& slot() {
  static Slot only;
  return only;
}
}  // namespace detail

/// Frees the data of the last row.
inline void forget() { detail::slot() = {}; }

/// The data of a row. Google Benchmark calls a row several times to find out how long to run it; the data are made at
/// the first call and freed before the next row makes its own, so that large rows find the memory free.
template <class Make>
auto& kept(std::string const& row, Make const& make) {
  using State = decltype(make());
  auto& slot = detail::slot();
  if (slot.row != row) {
    forget();
    slot = {row, std::make_shared<State>(make())};
  }
  return *static_cast<State*>(slot.state.get());
}

}  // namespace scree::bench
