// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include <scree/core/types.hpp>

#include <vector>

// The particles before the first step: compiled once, in points.cpp, for all models and precisions.
namespace drum {

/// Positions, m.
template <int Dim>
struct Points {
  std::vector<scree::Vec<Dim, double>> material, wall;
  std::vector<double> volumes;  // of the material, m^Dim
};

/// The bed fills the drum up to a level surface.
template <int Dim>
Points<Dim> points(Options const& o);

}  // namespace drum
