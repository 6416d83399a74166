// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

// Terms that represent any physics and use everything that the loop provides: scalar and vector sums, i's own fields,
// the particle itself.
namespace scree::test {

struct Charge : Scalar<"charge", "C"> {};
inline constexpr Charge charge{};
struct Temperature : Scalar<"temperature", "K"> {};
inline constexpr Temperature temperature{};
struct Force : Vector<"force", "N"> {};
inline constexpr Force force{};
struct Effort : Scalar<"sum of force magnitudes", "N"> {};
inline constexpr Effort effort{};
struct Potential : Scalar<"potential", "V"> {};
inline constexpr Potential potential{};
struct Heating : Scalar<"heating", "W"> {};
inline constexpr Heating heating{};
struct Neighbours : Integer<"number of neighbours", "1"> {};
inline constexpr Neighbours neighbours{};

/// Antisymmetric to the last bit: W's gradient changes sign, the rest is symmetric.
struct Repulsion {
  using reads = Fields<Charge, Volume>;
  using adds = Fields<Force>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[force] += -(i[charge] * j[charge]) * (i[volume] * j[volume]) * ij.gradW();
  }
};
struct RepulsionEffort {
  using reads = Fields<Charge, Volume>;
  using adds = Fields<Effort>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[effort] += Kokkos::abs((i[charge] * j[charge]) * (i[volume] * j[volume]) * ij.slope() * ij.r);
  }
};
/// Includes the particle itself.
struct Screening {
  using reads = Fields<Charge>;
  using adds = Fields<Potential>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[potential] += j[charge] * ij.W() / (1 + ij.r / ij.h());
  }
};
/// Reads a field of i that j need not have.
struct Heat {
  using reads = Fields<Charge>;
  using reads_i = Fields<Temperature>;
  using adds = Fields<Heating>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    sum[heating] += (i[temperature] + j[charge]) * sq(ij.r) * ij.slope();
  }
};
struct CountNeighbours {
  using reads = Fields<>;
  using adds = Fields<Neighbours>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const&, IJ const&, S& sum) const {
    sum[neighbours] += 1;
  }
};
struct CountWithItself : CountNeighbours {
  static constexpr bool includes_self = true;
};

/// Sees every particle of the source body with the opposite charge and i's own temperature added.
struct OppositeCharge {
  static constexpr bool takes_packs = true;
  using provides = Fields<Charge>;
  using reads = Fields<Density>;
  using reads_i = Fields<Temperature>;
  template <class I, class J>
  SCREE_FN auto operator()(Charge, I const& i, J const& j) const {
    return -j[fields::density] - i[temperature];
  }
};

struct LeftHalf {
  using reads = Fields<Position>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    using namespace fields;
    return i[position][0] < decltype(i[position][0])(0.5);
  }
};

/// Computes a temperature from the sums and the particle's own charge.
struct Glow {
  double factor;
  using reads = Fields<Charge>;
  using writes = Fields<Temperature>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    out[temperature] = factor * (total[potential] + i[charge]);
  }
};

}  // namespace scree::test
