// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/one_rank.hpp"
#include "../fields/standard.hpp"
#include "../neighbours/grid.hpp"
#include "../passes/survey.hpp"
#include "by_identity.hpp"
#include "divide.hpp"
#include "team.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {

/// Agreement of the ranks of a case, as OneRank (core/one_rank.hpp) for a case whose particles are all here.
template <class P>
class Agreement {
 public:
  /// Agreement of the ranks of a team.
  explicit Agreement(Team<typename P::space> const& team) : team_(team) {}

  /// The ranks of the case.
  Team<typename P::space> const& team() const { return team_; }
  /// Whether there are other ranks.
  bool several() const { return team_.ranks() > 1; }
  /// The largest value of a number on any rank; every rank gets it.
  double largest(double here) const { return team_.largest(here); }
  /// Whether a condition holds on at least one rank.
  bool on_any(bool here) const { return largest(here ? 1 : 0) > 0; }
  /// Joins the frames of each body over all ranks.
  void join(std::vector<Frame<P::dim>>& frames) const {
    auto const all = team_.gather(frames);
    std::size_t const bodies = frames.size();
    frames.assign(bodies, {});
    for (std::size_t k = 0; k < all.size(); ++k) frames[k % bodies].add(all[k]);
  }

  /// Returns the largest values on all ranks and the number of particles of all ranks. The particle of a value is known
  /// to the one rank that has it.
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

  /// Whether each rank has its own particles only: from the first lists on, or from the start if it begins with a
  /// share.
  bool scattered() const { return held_ != Held::whole; }
  /// Whether particles have gone to the ranks that their positions belong to.
  bool settled() const { return held_ == Held::own; }
  /// The values of all ranks, those of rank 0 first.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return scattered() ? detail::joined_values(team_, std::move(values)) : values;
  }
  /// The sum of a number of particles over all ranks.
  long sum(long here) const { return scattered() ? long(team_.sum(here)) : here; }
  /// Sums of integers over all ranks, element by element.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return scattered() ? team_.sum(here) : here; }
  /// Exact sums over all ranks, element by element, as numbers.
  std::vector<double> sum(std::vector<ExactSum> const& here) const {
    return scattered() ? team_.sum(here) : one_rank.sum(here);
  }
  /// The number of particles of all ranks.
  long count(AnyParticles<P> const& body) const { return detail::on_all_ranks(body) ? body.size() : sum(body.size()); }
  /// Brings values of the particles of all ranks, or of some of them by number, into the order of their identities.
  template <class Body, class... Numbers>
  detail::ByIdentity<typename P::space> order_of(Body const& body, Numbers const&... which) const {
    return {team_, body.to_host(fields::identity, which...), scattered() && !detail::on_all_ranks(body)};
  }
  /// Whether this rank is the one that reports for the case.
  bool reports() const { return team_.rank() == 0; }
  /// Whether particles that are added to the case are added here; they move to their rank with the next lists.
  bool takes_new() const { return !scattered() || reports(); }

 protected:
  enum class Held { whole, share, own };
  Held held_ = Held::whole;  // the particles of the case that this rank has

 private:
  Team<typename P::space> team_;
};

}  // namespace scree
