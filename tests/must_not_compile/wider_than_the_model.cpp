// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a_case_may_narrow_the_range_of_a_parameter_but_not_widen_it
// needs: __cpp_consteval
#include <scree/laws/mu_of_i.hpp>

#ifdef FIXED
scree::ParameterAbout about() { return scree::parameter_of<&scree::MuOfI<>::mu_s>.within(0, 2); }
#else
scree::ParameterAbout about() { return scree::parameter_of<&scree::MuOfI<>::mu_s>.within(-1, 2); }
#endif
