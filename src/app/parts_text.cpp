// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/parts_text.hpp>

#include <fmt/format.h>

namespace scree::app {
namespace {

std::string text_of(Place const& place) {
  if (place.device[0] != '\0') return fmt::format("{} {} on {}", place.device, place.number, place.host);
  return fmt::format("{} thread{} on {}", place.threads, place.threads == 1 ? "" : "s", place.host);
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

}  // namespace scree::app
