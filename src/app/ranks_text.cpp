// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/ranks_text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace scree::app {
namespace {

std::string text_of(Place const& place) {
  if (place.device[0] != '\0') return fmt::format("{} {} on {}", place.device, place.number, place.host);
  return fmt::format("{} thread{} on {}", place.threads, place.threads == 1 ? "" : "s", place.host);
}

/// The largest share of particles over the mean.
double imbalance_of(std::vector<RankProfile> const& ranks) {
  std::int64_t all = 0, most = 0;
  for (RankProfile const& rank : ranks) all += rank.particles, most = std::max(most, rank.particles);
  return all > 0 ? double(most) * double(ranks.size()) / double(all) : 1;
}

}  // namespace

std::string ranks_text(std::string const& transport, Link const& link, std::vector<Place> const& places) {
  std::string text = fmt::format("{} ranks, {}; between neighbours at least {:.3g} GB/s, 8 bytes in {:.3g} us\n",
                                 places.size(), transport, 1e-9 * link.bandwidth, 1e6 * link.latency);
  for (std::size_t rank = 0; rank < places.size();) {
    std::size_t last = rank;  // of those in the same place
    while (last + 1 < places.size() && text_of(places[last + 1]) == text_of(places[rank])) ++last;
    text += last == rank ? fmt::format("  rank {}: ", rank) : fmt::format("  ranks {} to {}: ", rank, last);
    text += text_of(places[rank]) + '\n';
    rank = last + 1;
  }
  return text;
}

std::string profile_text(std::vector<RankProfile> const& ranks) {
  RankProfile const& first = ranks.front();
  if (first.steps == 0) return "profile: no steps\n";
  auto const per_step = [&](double value) { return value / double(first.steps); };
  std::string text = fmt::format("profile of {} steps: {:.4g} ms per step", first.steps, 1e3 * per_step(first.seconds));
  if (first.builds > 0)
    text += fmt::format(", lists built every {:.4g} steps", double(first.steps) / double(first.builds));
  std::int64_t particles = 0, migrated = 0;
  for (RankProfile const& rank : ranks) particles += rank.particles, migrated += rank.migrated;
  text += fmt::format(", {} particles", particles);
  if (ranks.size() == 1) return text + "\n";

  text += fmt::format("\n{} ranks, the largest has {:.3f} times the mean; {} particles went to another rank\n",
                      ranks.size(), imbalance_of(ranks), migrated);
  text +=
      "each step    |      sent      | time in exchanges | in reductions\n"
      "rank  ghosts | messages    kB |     ms    share   |    ms   share\n";
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    auto const& [exchanges, gathers, messages, bytes, exchanging, gathering] = ranks[k].traffic;
    auto const share_of = [&](double seconds) { return 100 * seconds / ranks[k].seconds; };
    double const ghosts = 100 * double(ranks[k].ghosts) / double(std::max<std::int64_t>(ranks[k].particles, 1));
    text += fmt::format("{:4} {:5.1f} % | {:8.1f} {:5.0f} | {:8.3f} {:5.1f} %  | {:7.3f} {:5.1f} %\n", k, ghosts,
                        per_step(double(messages)), 1e-3 * per_step(double(bytes)), 1e3 * per_step(exchanging),
                        share_of(exchanging), 1e3 * per_step(gathering), share_of(gathering));
  }
  return text + "Times include waiting for other ranks. Ghosts: share of the rank's own particles.\n";
}

}  // namespace scree::app
