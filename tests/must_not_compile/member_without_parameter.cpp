// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this member is not in the parameters\(\) of its class
#include <scree/core/parameter.hpp>

struct Spring {
  double stiffness = 1, length = 1;
  static constexpr auto parameters() {
    return std::array{
        scree::parameter("stiffness", &Spring::stiffness, "N/m", "force over length", scree::allowed::above(0))};
  }
};

#ifdef FIXED
auto const& about = scree::parameter_of<&Spring::stiffness>;
#else
auto const& about = scree::parameter_of<&Spring::length>;
#endif
