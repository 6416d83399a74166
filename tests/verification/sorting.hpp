// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>

// Exact solutions of segregation without diffusion, C_t = (C (1 - C))_z in a layer of height 1, no flux through floor
// and surface: lengths in the height H, times in H/V, symmetric flux (Gray & Thornton 2005).
namespace scree::test::sorting {

/// Small and large grains evenly mixed at the start: a shock rises from the floor, with only small grains below it;
/// another sinks from the surface, with only large ones above it. They meet at z = mixed, t = 1.
struct Mixed {
  double mixed = 0.3;  ///< C at the start
  double operator()(double z, double t) const {
    double const below = std::min(mixed * t, mixed), above = std::max(1 - (1 - mixed) * t, mixed);
    return z < below ? 1 : z > above ? 0 : mixed;
  }
  double sorted() const { return 1; }        ///< time after which nothing changes
  double boundary() const { return mixed; }  ///< height up to which there are small grains in the end
};

/// Small grains above an interface at the start: a fan opens; shocks start where it meets floor and surface.
struct Inverted {
  double interface = 0.4;  ///< its height
  double operator()(double z, double t) const {
    double const low = interface, high = 1 - interface;
    double const below = t > low ? low + t - 2 * std::sqrt(low * t) : 0;
    double const above = t > high ? low - t + 2 * std::sqrt(high * t) : 1;
    if (t >= sorted()) return z < boundary() ? 1 : 0;
    if (z < below) return 1;
    if (z > above) return 0;
    return t > 0 ? std::clamp((1 + (z - interface) / t) / 2, 0.0, 1.0) : z > interface ? 1 : 0;
  }
  double sorted() const { return 1 + 2 * std::sqrt(interface * (1 - interface)); }
  double boundary() const { return 1 - interface; }
};

}  // namespace scree::test::sorting
