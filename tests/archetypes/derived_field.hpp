// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/io/derived_field.hpp>

namespace scree::test::archetypes {

struct Squared : Scalar<"squared concentration", "1"> {
  using reads = Fields<Concentration>;
  template <class I>
  static auto of(I const& i, Resolution const&) {
    using namespace fields;
    return i[concentration] * i[concentration];
  }
};
inline constexpr Squared squared{};
static_assert(DerivedField<Squared>);

}  // namespace scree::test::archetypes
