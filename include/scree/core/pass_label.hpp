// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace scree {

/// The name of a pass in profilers and messages. A label uses no heap memory, because the passes of a step are
/// constructed and fused again in every step. Text beyond `longest` characters is cut off.
class PassLabel {
 public:
  static constexpr std::size_t longest = 111;

  constexpr PassLabel() = default;
  /// A label with this text.
  constexpr PassLabel(char const* text) : PassLabel(std::string_view(text)) {}
  /// A label with this text.
  PassLabel(std::string const& text) : PassLabel(std::string_view(text)) {}
  /// A label with this text.
  constexpr PassLabel(std::string_view text) { add(text); }

  /// Returns the text, without any part that was cut off.
  constexpr std::string_view text() const { return {text_.data(), size_}; }
  constexpr operator std::string_view() const { return text(); }
  /// Returns this label with further text appended.
  constexpr PassLabel operator+(std::string_view more) const {
    PassLabel longer = *this;
    longer.add(more);
    return longer;
  }
  friend constexpr bool operator==(PassLabel const& a, std::string_view b) { return a.text() == b; }

 private:
  constexpr void add(std::string_view more) {
    std::size_t const count = std::min(more.size(), longest - size_);
    std::copy_n(more.begin(), count, text_.begin() + size_);
    size_ += count;
  }

  std::array<char, longest + 1> text_ = {};
  std::size_t size_ = 0;
};

}  // namespace scree
