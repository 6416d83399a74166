// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/codec.hpp>

#include <scree/app/text.hpp>

#include <fmt/ranges.h>

#include <cmath>

namespace scree::app {

namespace detail {

std::string text_of(Range const& range) {
  auto const [from, to, open, open_end, words] = range;
  if (std::isinf(from) && std::isinf(to)) return "";
  if (std::isinf(to)) return fmt::format(" {} {}", open ? ">" : ">=", from);
  return fmt::format(" in {}{}, {}{}", open ? "(" : "[", from, to, open_end ? ")" : "]");
}

std::string quoted(std::string_view text) {
  std::string all = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\')
      all += '\\', all += c;
    else if (static_cast<unsigned char>(c) < 32 || c == 127)
      all += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      all += c;
  }
  return all + '"';
}

std::string with_unit(About const& about) { return about.unit.empty() || about.unit == "1" ? "" : " " + about.unit; }

namespace {
[[noreturn]] void refuse_kind(Value const& value, char const* expected) {
  throw Problem{value.where, fmt::format("{} where {} is expected", value.kind(), expected)};
}
void refuse_too_large(Value const& value) {
  if (auto const* number = std::get_if<Value::TooLarge>(&value.data))
    throw Problem{value.where,
                  fmt::format("{} is out of range, as all {}", shortened(number->written), number->beyond)};
}
}  // namespace

std::string allowed_integers(About const& about) { return "an integer" + text_of(about.range) + with_unit(about); }

std::int64_t read_integer(Value const& value, About const& about, std::int64_t least, std::int64_t largest) {
  refuse_too_large(value);
  auto const* number = std::get_if<std::int64_t>(&value.data);
  if (number == nullptr) refuse_kind(value, "an integer");
  if (*number < least || *number > largest || !about.range.has(static_cast<double>(*number)))
    throw Problem{value.where, fmt::format("{} is out of range", *number)};
  return *number;
}

std::string allowed_names(std::vector<std::string> const& names) {
  std::vector<std::string> all;
  for (auto const& name : names) all.push_back(detail::quoted(name));
  return join(all);
}

std::size_t read_name(Value const& value, std::vector<std::string> const& names) {
  auto const* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) refuse_kind(value, "a name in quotes");
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == *text) return k;
  auto const hint = nearest(*text, names);
  throw Problem{value.where, fmt::format("unknown name {}{}", detail::quoted(shortened(*text)),
                                         hint.empty() ? "" : ", did you mean " + detail::quoted(hint) + "?")};
}

}  // namespace detail

std::string Codec<bool>::allowed(About const&) { return "true or false"; }
bool Codec<bool>::read(Value const& value, About const&) {
  if (auto const* found = std::get_if<bool>(&value.data)) return *found;
  detail::refuse_kind(value, "true or false");
}
std::string Codec<bool>::text(bool value) { return value ? "true" : "false"; }

std::string Codec<double>::allowed(About const& about) {
  return "a number" + detail::text_of(about.range) + detail::with_unit(about);
}
double Codec<double>::read(Value const& value, About const& about) {
  detail::refuse_too_large(value);
  double number = 0;
  if (auto const* real = std::get_if<double>(&value.data))
    number = *real;
  else if (auto const* whole = std::get_if<std::int64_t>(&value.data))
    number = static_cast<double>(*whole);
  else
    detail::refuse_kind(value, "a number");
  if (!std::isfinite(number)) throw Problem{value.where, fmt::format("{} is not a finite number", number)};
  if (!about.range.has(number)) throw Problem{value.where, fmt::format("{} is out of range", number)};
  return number;
}
std::string Codec<double>::text(double value) { return fmt::format("{}", value); }

std::string Codec<std::string>::allowed(About const&) { return "a text in quotes"; }
std::string Codec<std::string>::read(Value const& value, About const&) {
  if (auto const* text = std::get_if<std::string>(&value.data)) return *text;
  detail::refuse_kind(value, "a text in quotes");
}
std::string Codec<std::string>::text(std::string const& value) { return detail::quoted(value); }

std::string Codec<std::vector<double>>::allowed(About const& about) {
  auto const range = detail::text_of(about.range);
  return "an array of numbers, each" + (range.empty() ? " finite" : range) + detail::with_unit(about);
}
std::vector<double> Codec<std::vector<double>>::read(Value const& value, About const& about) {
  auto const* array = std::get_if<Value::Array>(&value.data);
  if (array == nullptr) detail::refuse_kind(value, "an array of numbers");
  std::vector<double> numbers;
  for (auto const& element : *array) numbers.push_back(Codec<double>::read(element, about));
  return numbers;
}
std::string detail::allowed_array(int count, About const& about) {
  auto const range = text_of(about.range);
  return fmt::format("an array of {} numbers{}{}", count, range.empty() ? "" : ", each" + range, with_unit(about));
}
std::vector<double> detail::read_array(Value const& value, About const& about, int count) {
  auto numbers = Codec<std::vector<double>>::read(value, about);
  if (numbers.size() != std::size_t(count))
    throw Problem{value.where, fmt::format("an array of {} where one of {} is expected", numbers.size(), count)};
  return numbers;
}
std::string Codec<std::vector<double>>::text(std::vector<double> const& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace scree::app
