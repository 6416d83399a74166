// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/volume_memory.hpp"
#include "flow_consistency.hpp"

#include <type_traits>

namespace scree {

/// The volume control that a law needs: FlowConsistency if the law is Cohesionless, NoVolumeControl otherwise.
struct ControlByLaw {};

namespace granular {

/// The volume control that the models of Granular name.
template <class Control, class Law>
struct VolumeControlOf {
  using type = Control;
};
template <class Law>
struct VolumeControlOf<ControlByLaw, Law> {
  using type = std::conditional_t<Cohesionless<Law>, FlowConsistency, NoVolumeControl>;
};
/// The volume control of a granular model: `Control`, or the one that the law needs.
template <class Control, class Law>
using volume_control_of = typename VolumeControlOf<Control, Law>::type;

/// The law that evolves the stress: `Law`, with a memory of gaps if the volume control needs one.
template <class Law, class Control>
struct EvolvedLaw {
  using type = Law;
};
template <class Law, NeedsMemory Control>
requires(!OneOf<Opening, typename Law::history>) struct EvolvedLaw<Law, Control> {
  using type = VolumeMemory<Law>;
};
/// The law that evolves the stress, with a memory of gaps if the volume control needs one.
template <class Law, class Control>
using evolved_law = typename EvolvedLaw<Law, Control>::type;

}  // namespace granular
}  // namespace scree
