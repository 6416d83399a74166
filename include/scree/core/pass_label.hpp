// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace scree {

/// The name of a pass in profilers and messages, without memory from the heap: the passes of a step are made and fused
/// again in each step. Text beyond `longest` characters is cut.
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

  /// The text, as far as it was not cut.
  constexpr std::string_view text() const { return {text_.data(), size_}; }
  constexpr operator std::string_view() const { return text(); }
  /// This label with further text.
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
