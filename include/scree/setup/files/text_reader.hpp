// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scree::detail {

/// A reader of text, line by line, which splits each line at blanks. All its messages name the file and the line. The
/// text must outlive the reader.
class TextReader {
 public:
  TextReader(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// Advances to the next line with at least one word; returns false at the end of the text. With `joined`, a backslash
  /// at the end of a line continues the line.
  bool next(bool joined = false) {
    words_.clear();
    while (!rest_.empty() && words_.empty())
      while (take_line() && joined && continued_) {
      }
    return !words_.empty();
  }
  std::vector<std::string_view> const& words() const { return words_; }
  std::string_view word(std::size_t k) const { return words_[k]; }
  /// Returns the number of the line, from 1.
  int line() const { return line_; }

  [[noreturn]] void fail(std::string const& why) const {
    throw std::runtime_error(name_ + ", line " + std::to_string(line_) + ": " + why);
  }
  void demand(bool holds, char const* why) const {
    if (!holds) fail(why);
  }
  /// Returns word k as a finite number. Throws std::runtime_error if it is not one.
  double number(std::size_t k) const {
    double const value = converted<double>(k, "a number");
    if (!std::isfinite(value)) fail("'" + std::string(words_[k]) + "' is not a finite number");
    return value;
  }
  long integer(std::size_t k) const { return converted<long>(k, "a whole number"); }

 private:
  bool take_line() {
    if (rest_.empty()) return false;
    std::size_t const end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    continued_ = !line.empty() && line.back() == '\\';
    if (continued_) line.remove_suffix(1);
    static constexpr std::string_view blanks = " \t\v\f\r";
    for (std::size_t from = line.find_first_not_of(blanks); from != line.npos;) {
      std::size_t const to = std::min(line.find_first_of(blanks, from), line.size());
      words_.push_back(line.substr(from, to - from));
      from = line.find_first_not_of(blanks, to);
    }
    return true;
  }
  template <class Number>
  Number converted(std::size_t k, char const* wanted) const {
    if (k >= words_.size()) fail(std::string("the line ends where ") + wanted + " is expected");
    std::string_view word = words_[k];
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    Number value{};
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
      fail("'" + std::string(words_[k].substr(0, 40)) + "' is not " + wanted);
    return value;
  }

  std::string_view rest_;
  std::string name_;
  std::vector<std::string_view> words_;
  int line_ = 0;
  bool continued_ = false;
};

}  // namespace scree::detail
