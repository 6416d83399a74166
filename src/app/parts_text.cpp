// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/parts_text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace scree::app {
namespace {

std::string text_of(Place const& place) {
  if (place.device[0] != '\0') return fmt::format("{} {} on {}", place.device, place.number, place.host);
  return fmt::format("{} thread{} on {}", place.threads, place.threads == 1 ? "" : "s", place.host);
}

/// The largest share of particles over the mean.
double imbalance_of(std::vector<PartProfile> const& parts) {
  std::int64_t all = 0, most = 0;
  for (PartProfile const& part : parts) all += part.particles, most = std::max(most, part.particles);
  return all > 0 ? double(most) * double(parts.size()) / double(all) : 1;
}

}  // namespace

std::string parts_text(std::string const& transport, Link const& link, std::vector<Place> const& places) {
  std::string text = fmt::format("{} parts, {}; between neighbours at least {:.3g} GB/s, 8 bytes in {:.3g} us\n",
                                 places.size(), transport, 1e-9 * link.bandwidth, 1e6 * link.latency);
  for (std::size_t part = 0; part < places.size();) {
    std::size_t last = part;  // of those in the same place
    while (last + 1 < places.size() && text_of(places[last + 1]) == text_of(places[part])) ++last;
    text += last == part ? fmt::format("  part {}: ", part) : fmt::format("  parts {} to {}: ", part, last);
    text += text_of(places[part]) + '\n';
    part = last + 1;
  }
  return text;
}

std::string profile_text(std::vector<PartProfile> const& parts) {
  PartProfile const& first = parts.front();
  if (first.steps == 0) return "profile: no steps\n";
  auto const per_step = [&](double value) { return value / double(first.steps); };
  std::string text = fmt::format("profile of {} steps: {:.4g} ms per step", first.steps, 1e3 * per_step(first.seconds));
  if (first.builds > 0)
    text += fmt::format(", lists built every {:.4g} steps", double(first.steps) / double(first.builds));
  std::int64_t particles = 0, migrated = 0;
  for (PartProfile const& part : parts) particles += part.particles, migrated += part.migrated;
  text += fmt::format(", {} particles", particles);
  if (parts.size() == 1) return text + "\n";

  text += fmt::format("\n{} parts, the largest has {:.3f} times the mean; {} particles went to another part\n",
                      parts.size(), imbalance_of(parts), migrated);
  text +=
      "each step    |      sent      | time in exchanges | in reductions\n"
      "part  ghosts | messages    kB |     ms    share   |    ms   share\n";
  for (std::size_t k = 0; k < parts.size(); ++k) {
    auto const& [exchanges, gathers, messages, bytes, exchanging, gathering] = parts[k].traffic;
    auto const share_of = [&](double seconds) { return 100 * seconds / parts[k].seconds; };
    double const ghosts = 100 * double(parts[k].ghosts) / double(std::max<std::int64_t>(parts[k].particles, 1));
    text += fmt::format("{:4} {:5.1f} % | {:8.1f} {:5.0f} | {:8.3f} {:5.1f} %  | {:7.3f} {:5.1f} %\n", k, ghosts,
                        per_step(double(messages)), 1e-3 * per_step(double(bytes)), 1e3 * per_step(exchanging),
                        share_of(exchanging), 1e3 * per_step(gathering), share_of(gathering));
  }
  return text + "Times include waiting for other parts. Ghosts: share of the part's own particles.\n";
}

}  // namespace scree::app
