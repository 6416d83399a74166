// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/in_layers.hpp"
#include "thin_walls.hpp"

namespace scree {

SCREE_BODY void ParticlesAtWalls::put_material(PlacedParticles const& material) {
  owned = material.places.size();
  all.places.insert(all.places.begin(), material.places.begin(), material.places.end());
  all.numbers.insert(all.numbers.begin(), material.numbers.begin(), material.numbers.end());
}

SCREE_BODY ThinWalls::ThinWalls(ParticlesAtWalls const& particles, double spacing, int dimensions)
    : particles_(particles),
      dimensions_(dimensions),
      look_(particles.all.places, particles.owned, spacing, dimensions, particles.support) {
  if (particles.owned > 0) find();
}

SCREE_BODY std::string ThinWalls::text() const {
  auto const& x = particles_.all.places[particles_.owned + found_.place];
  detail::WallView const view = look_(x);
  return detail::formatted(
      "scree: the wall is too thin at its particle %zu at (%.6g, %.6g%s) m: %s; if this is meant, set `start_checks "
      "= false`",
      found_.lowest, x[0], x[1], dimensions_ == 2 ? "" : detail::formatted(", %.6g", x[2]).c_str(),
      view.text(fault(view, found_.place)).c_str());
}

SCREE_BODY detail::ThinWall ThinWalls::fault(detail::WallView const& view, std::size_t w) const {
  return view.fault(particles_.is_plate[w] != 0, w < particles_.turns.size() && particles_.turns[w] != 0);
}

SCREE_BODY void ThinWalls::find() {
  std::size_t const at_once = 64;
  std::vector<Found> all_found(look_.cells() / at_once + 1);
  detail::for_each_layer(static_cast<long>(all_found.size()), [&](long portion) {
    Found& found = all_found[static_cast<std::size_t>(portion)];
    std::size_t const first = static_cast<std::size_t>(portion) * at_once;
    look_.visit_cells(first, std::min(first + at_once, look_.cells()),
                      [&](std::size_t w, detail::WallView const& view) {
                        if (w >= particles_.looked_at || fault(view, w) == detail::ThinWall::none) return;
                        auto const& numbers = particles_.all.numbers;
                        found.add(1, numbers.empty() ? w : std::size_t(numbers[particles_.owned + w]), w);
                      });
  });
  for (Found const& each : all_found) found_.add(each.faults, each.lowest, each.place);
}

}  // namespace scree
