// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <type_traits>

// Concepts that find optional members of models by name alone. Without them, a member with the right name but the wrong
// parameters, or without const, would be silently ignored.
namespace scree::detail {

// If both bases of a class have a member of the same name, the name is ambiguous, whatever kind of member it is.
#define SCREE_HAS_MEMBER(Concept, member)                                    \
  struct Other##Concept {                                                    \
    int member;                                                              \
  };                                                                         \
  template <class T>                                                         \
  struct With##Concept : T, Other##Concept {};                               \
  template <class T>                                                         \
  concept Concept = std::is_class_v<T> && !std::is_final_v<T> && !requires { \
    &With##Concept<T>::member;                                               \
  }

/// Whether a class has a member with the given name: a variable, a type, or a function with any parameters.
SCREE_HAS_MEMBER(HasMemberCheck, check);
SCREE_HAS_MEMBER(HasMemberValidity, validity);
SCREE_HAS_MEMBER(HasMemberFilters, filters);
SCREE_HAS_MEMBER(HasMemberFilterPeriod, filter_period);
SCREE_HAS_MEMBER(HasMemberProjections, projections);
SCREE_HAS_MEMBER(HasMemberPassesWith, passes_with);
SCREE_HAS_MEMBER(HasMemberPasses, passes);
SCREE_HAS_MEMBER(HasMemberTerms, terms);
SCREE_HAS_MEMBER(HasMemberAcceleration, acceleration);
#undef SCREE_HAS_MEMBER

/// Whether a law or a physics model has a mistake that the compiler has already reported.
template <class T>
concept IsRefused = requires {
  typename T::refused;
};

}  // namespace scree::detail
