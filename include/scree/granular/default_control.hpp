// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/volume_memory.hpp"
#include "flow_consistency.hpp"

#include <type_traits>

namespace scree {

/// The default volume control: FlowConsistency if the law is Cohesionless, otherwise NoVolumeControl.
struct ControlByLaw {};

namespace granular {

/// Selects the type of volume_control_of.
template <class Control, class Law>
struct VolumeControlOf {
  using type = Control;
};
template <class Law>
struct VolumeControlOf<ControlByLaw, Law> {
  using type = std::conditional_t<Cohesionless<Law>, FlowConsistency, NoVolumeControl>;
};
/// The volume control of a granular model: `Control`, or the default for the law if `Control` is ControlByLaw.
template <class Control, class Law>
using volume_control_of = typename VolumeControlOf<Control, Law>::type;

/// Selects the type of evolved_law.
template <class Law, class Control>
struct EvolvedLaw {
  using type = Law;
};
template <class Law, NeedsMemory Control>
requires(!OneOf<Opening, typename Law::history>) struct EvolvedLaw<Law, Control> {
  using type = VolumeMemory<Law>;
};
/// The law that evolves the stress: VolumeMemory<Law> if the volume control needs a memory of gaps that `Law` does not
/// have, otherwise `Law`.
template <class Law, class Control>
using evolved_law = typename EvolvedLaw<Law, Control>::type;

}  // namespace granular
}  // namespace scree
