// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/whole_case.hpp"
#include "../fields/bodies.hpp"
#include "../fields/standard.hpp"
#include "../neighbours/grid.hpp"
#include "../passes/survey.hpp"
#include "../snapshots/snapshot.hpp"
#include "by_identity.hpp"
#include "divide.hpp"
#include "team.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// Agreement of the ranks of a case on quantities of all its particles, used instead of WholeCase
/// (core/whole_case.hpp). All ranks call its functions together.
template <class P>
class Agreement {
 public:
  /// Makes the object by which this rank reaches agreement with the other ranks of a team.
  explicit Agreement(Team<typename P::space> const& team) : team_(team) {}

  /// Returns the team of the ranks of the case.
  Team<typename P::space> const& team() const { return team_; }
  /// Whether this rank has all particles of the case. Unless ranks begin with shares, this is so until the first
  /// neighbour lists are built.
  bool all_here() const { return held_ == Held::whole; }
  /// Throws std::logic_error unless this rank has all particles of the case.
  void require_all_here() const {
    if (!all_here())
      throw std::logic_error(
          "scree: set rest positions before the first step or rates: on ranks, surfaces of rigid bodies and walls "
          "are found while each rank has the whole case");
  }
  /// Whether the case has more than one rank.
  bool is_shared() const { return team_.ranks() > 1; }
  /// Returns, on every rank, the largest value of a number over all ranks.
  double largest(double here) const { return team_.largest(here); }
  /// Whether a condition holds on at least one rank.
  bool anywhere(bool here) const { return largest(here ? 1 : 0) > 0; }
  /// Extends the frame of each body to contain the frames of the body on all ranks.
  void join(std::vector<Frame<P::dim>>& frames) const {
    auto const all = team_.gather(frames);
    std::size_t const bodies = frames.size();
    frames.assign(bodies, {});
    for (std::size_t k = 0; k < all.size(); ++k) frames[k % bodies].add(all[k]);
  }

  /// Returns the largest values over all ranks and the total number of particles. Only the rank that holds a largest
  /// value gets the index of its particle.
  template <std::size_t Count>
  std::pair<std::array<Largest, Count>, long> joined(std::array<Largest, Count> const& here, long particles) const {
    struct Found {
      std::array<Largest, Count> largest;
      long particles;
    };
    auto const all = team_.gather(Found{here, particles});
    std::array<Largest, Count> joined = {};
    long count = 0;
    for (Found const& each : all) count += each.particles;
    for (std::size_t k = 0; k < Count; ++k) {
      int first = -1;  // the first rank with the largest value
      for (int q = 0; q < team_.ranks(); ++q) {
        auto const& [largest, number] = all[std::size_t(q)];
        joined[k].beyond += largest[k].beyond;
        if (number > 0 && (first < 0 || largest[k].value > joined[k].value))
          joined[k].value = largest[k].value, first = q;
      }
      joined[k].particle = first == team_.rank() ? here[k].particle : detail::no_particle;
    }
    return {joined, count};
  }

  /// Returns the values on all ranks, in the order of the ranks.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return all_here() ? values : detail::joined_values(team_, std::move(values));
  }
  /// Returns the sum of a number of particles over all ranks.
  long sum(long here) const { return all_here() ? here : long(team_.sum(here)); }
  /// Returns the sums of integers over all ranks, element by element.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return all_here() ? here : team_.sum(here); }
  /// Returns the values of exact sums over all ranks, element by element.
  std::vector<double> sum(std::vector<ExactSum> const& here) const {
    return all_here() ? whole_case_here.sum(here) : team_.sum(here);
  }
  /// Returns the number of particles of a body on all ranks.
  long count(AnyParticles<P> const& body) const { return detail::on_all_ranks(body) ? body.size() : sum(body.size()); }
  /// Returns an object that sorts values of the particles on all ranks by particle identity; `which` selects particles
  /// by number.
  template <class Body, class... Numbers>
  detail::ByIdentity<typename P::space> order_of(Body const& body, Numbers const&... which) const {
    return {team_, body.to_host(fields::identity, which...), !all_here() && !detail::on_all_ranks(body)};
  }
  /// Replaces the particle arrays in the snapshot of a system by the values on all ranks, in the order of identities.
  template <class Sys>
  [[gnu::cold]] void collect(Snapshot& snapshot, Sys const& system) const {
    detail::for_each_body(typename Sys::bodies{}, [&]<class Body>() {
      auto const& body = system.template body<Body>();
      auto const order = order_of(body);
      std::string const name(Body::name);
      for (SnapshotArray& array : snapshot.arrays) {
        bool const of_lists = array.name == "neighbours/" + name && system.neighbour_builds() > 0 && !all_here();
        if (!of_lists && array.name.rfind(name + "/", 0) != 0) continue;
        array.bytes.resize(array.bytes_of_each() * std::size_t(body.size()));  // without ghosts
        array.bytes = order.of(std::move(array.bytes), array.bytes_of_each());
      }
    });
  }
  /// Whether this rank reports for the case, which is rank 0.
  bool reports() const { return team_.rank() == 0; }
  /// Whether particles that enter the case are added on this rank; they move to their own rank when neighbour lists are
  /// next built.
  bool takes_new() const { return all_here() || reports(); }

 protected:
  enum class Held { whole, share, own };
  Held held_ = Held::whole;  // the particles of the case that this rank has

 private:
  Team<typename P::space> team_;
};

}  // namespace scree
