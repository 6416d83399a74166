// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/list.hpp"

namespace scree {

/// Two functions of the sums of one pair loop, declared separately and computed in one sweep. The second function may
/// overwrite values that the first writes.
template <class First, class Second>
struct Together {
  First first;
  Second second;
  using reads = Merge<reads_of<First>, reads_of<Second>>;
  using writes = Merge<writes_of<First>, writes_of<Second>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    first(i, total, out);
    second(i, total, out);
  }
};

/// Returns two functions of the sums of one pair loop as one function.
template <class First, class Second>
Together<First, Second> together(First const& first, Second const& second) {
  return {first, second};
}

}  // namespace scree
