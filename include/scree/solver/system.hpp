// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../kernels/kernel.hpp"
#include "searches.hpp"

#include <vector>

namespace scree {

/// Particles of all bodies with their kernel, neighbours and periodic images: what passes work on.
template <class P, class Search, class MaterialFields, class WallFields>
class System {
 public:
  using policy = P;

  System(double smoothing_length, std::vector<Period> const& periods)
      : kernel_(smoothing_length),
        images_{{periods, kernel_.radius()}, {periods, kernel_.radius()}},
        searches_(kernel_.radius()) {}

  kernel_of<P> const& kernel() const { return kernel_; }

  template <BodyTag Body>
  auto& body() {
    return bodies_.template of<Body>();
  }
  template <BodyTag Body>
  auto const& body() const {
    return bodies_.template of<Body>();
  }

  /// Neighbours of the target body's particles among the source body's, for the present positions.
  template <BodyTag Target, BodyTag Source>
  Search const& neighbours() {
    return searches_.template neighbours<Target, Source>({places_of<Material>(), places_of<Wall>()});
  }
  Searches<P, Search>& searches() { return searches_; }
  Searches<P, Search> const& searches() const { return searches_; }
  long neighbour_builds() const { return searches_.builds(); }

  /// To be called after positions changed.
  void positions_changed() {
    images_.material.create(bodies_.material);
    images_.wall.create(bodies_.wall);
    // Periodic images are made anew, and particles that leave a period jump.
    searches_.positions_changed(images_.material.any());
  }
  /// To be called at the beginning of a step.
  void wrap_periods() {
    if (!images_.material.any()) return;
    images_.material.wrap(bodies_.material);
    images_.wall.wrap(bodies_.wall);
    positions_changed();
  }
  template <BodyTag Body, class List>
  void refresh_ghosts(List fields) {
    images_.template of<Body>().refresh(body<Body>(), fields);
  }

 private:
  template <BodyTag Body>
  Places<P> places_of() const {
    return {body<Body>()[position], body<Body>().size()};
  }

  kernel_of<P> kernel_;
  PerBody<Particles<P, MaterialFields>, Particles<P, WallFields>> bodies_;
  PerBody<PeriodicImages<P>> images_;
  Searches<P, Search> searches_;
};

}  // namespace scree
