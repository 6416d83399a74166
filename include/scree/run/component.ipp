// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "component.hpp"

#include <stdexcept>

namespace scree::detail {

SCREE_BODY void AttachedComponents::attach(std::shared_ptr<AnyComponent> component) {
  if (!component) throw std::invalid_argument("scree: attach() was given no component");
  for (auto const& each : all_)
    if (each.component == component) throw std::invalid_argument("scree: this component is attached already");
  all_.push_back({std::move(component)});
}

SCREE_BODY void AttachedComponents::ask_again(AnyComponent const& component) {
  for (auto& each : all_)
    if (each.component.get() == &component) each.asked_after = never;
}

SCREE_BODY std::string AttachedComponents::signature() const {
  std::string text;
  for (auto const& each : all_) text += each.component->signature();
  return text;
}

/// Returns the name under which a snapshot stores the counters of a component.
inline std::string heading_of_component(std::size_t number) { return "component " + std::to_string(number); }

SCREE_BODY void AttachedComponents::save(Snapshot& snapshot, long steps) const {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    all_[k].component->save(snapshot);
    add_counters(snapshot, heading_of_component(k),
                 {{"started", all_[k].started}, {"asked", all_[k].asked_after == steps}});
  }
}

SCREE_BODY std::vector<AttachedComponents::Attached> AttachedComponents::all_in(Snapshot const& snapshot) const {
  auto attached = all_;
  for (std::size_t k = 0; k < all_.size(); ++k) {
    auto counts = counters_of(snapshot, heading_of_component(k));
    bool const knows = !counts.empty();  // snapshots of 0.1.0 have no such counters
    attached[k].started = !knows || counts["started"] != 0;
    attached[k].asked_after = (knows ? counts["asked"] != 0 : snapshot.steps > 0) ? snapshot.steps : never;
  }
  return attached;
}

}  // namespace scree::detail
