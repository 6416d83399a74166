// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/run/observer.hpp>

namespace scree::test::archetypes {

/// Counts its calls, at each full second.
template <class S>
Observer<S> counting(int& calls) {
  return {[](double now) { return std::floor(now) + 1; }, [&calls](S&) { ++calls; }};
}

}  // namespace scree::test::archetypes
