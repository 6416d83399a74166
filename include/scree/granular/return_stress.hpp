// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../laws/law.hpp"
#include "section.hpp"
#include "strain.hpp"
#include "stress_filter.hpp"

namespace scree::granular {

/// Maps the updated stress of a particle to an admissible stress and accumulates the yielding for the filter. `Named`
/// is the section named by the models.
template <class Law, class Named, class OfFilter>
struct Admit {
  Law law;
  using history = Merge<typename Law::history, OfFilter>;
  using reads = Merge<Fields<Stress>, point_of<Law>, history>;
  using writes = Merge<Fields<Stress>, history>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    using Real = typename Packed::Scalar;
    constexpr int dim = Packed::RowsAtCompileTime == 4 ? 2 : 3;
    keep_history(i, out, typename Law::history{});
    StressTensor<Real> const trial = unpacked(i[stress]);
    StressTensor<Real> const admitted = law.admissible(trial, at_section<section_of<Named, Law, dim>>(i), out);
    out[stress] = packed<dim>(admitted);
    if constexpr (OneOf<Yielding, OfFilter>) {
      StressTensor<Real> const taken = trial - admitted;
      out[yielding] = i[yielding] + equivalent_shear_stress(deviator_of(taken)) / bulk_modulus_at(law, trial, i);
    }
    keep_what_is_not_finite(i, out, writes{});
  }

 private:
  template <class I, class O, class... Fs>
  SCREE_FN static void keep_history(I const& i, O& out, Fields<Fs...>) {
    ((out[Fs{}] = i[Fs{}]), ...);
  }
  /// Keeps values that are not finite, so that the run stops: a law may turn NaN into a number.
  template <class I, class O, class... Fs>
  SCREE_FN static void keep_what_is_not_finite(I const& i, O& out, Fields<Fs...>) {
    (keep(i, out, Fs{}), ...);
  }
  template <class I, class O, class F>
  SCREE_FN static void keep(I const& i, O& out, F field) {
    if (!detail::is_finite(i[field])) out[field] = i[field];
  }
};

}  // namespace scree::granular
