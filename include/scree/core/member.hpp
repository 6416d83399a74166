// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <type_traits>

// Optional members of models. A member with the right name that has other parameters than those it is called with, or
// is not const, would be ignored. These concepts find such a member by its name.
namespace scree::detail {

// A name that both bases of a class have is ambiguous, whatever it names.
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

/// Whether a class has a member of that name: a variable, a type, or a function with any parameters.
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

/// A law or physics with a mistake, which the compiler has already reported.
template <class T>
concept IsRefused = requires {
  typename T::refused;
};

}  // namespace scree::detail
