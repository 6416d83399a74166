// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "prescribe.hpp"
#include "rotation.hpp"

// Checks of a steady rotation, which many cases have, in the library scree::compiled.
#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(Dim)                                                                                           \
  SCREE_INSTANCE void scree::detail::check_affine(scree::Rotation const&, std::vector<scree::Vec<Dim, double>> const&, \
                                                  double);                                                             \
  SCREE_INSTANCE scree::detail::PathOfPoint scree::detail::path_of<scree::Rotation, Dim>(                              \
      scree::Rotation const&, scree::Vec<Dim, double> const&, bool);                                                   \
  SCREE_INSTANCE bool scree::detail::may_turn(scree::Rotation const&, scree::Vec<Dim, float> const&, double);          \
  SCREE_INSTANCE bool scree::detail::may_turn(scree::Rotation const&, scree::Vec<Dim, double> const&, double)
SCREE_INSTANCES(2);
SCREE_INSTANCES(3);
#undef SCREE_INSTANCES
#endif
