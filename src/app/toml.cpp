// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/toml.hpp>

#include <scree/app/json.hpp>
#include <scree/app/text.hpp>

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

namespace scree::app {

namespace {

Where where_of(toml::source_region const& region, std::string const& source) {
  return {source, region.begin.line, region.begin.column};
}

/// A text in TOML, and the numbers in it that are too large, by their places.
struct Parsed {
  toml::table root = {};
  std::map<Where, Value::TooLarge> too_large = {};
};

Value value_of(toml::node const& node, std::string const& source, Parsed const& parsed) {
  Value value{.data = {}, .where = where_of(node.source(), source)};
  if (auto const* b = node.as_boolean())
    value.data = b->get();
  else if (auto const* i = node.as_integer())
    value.data = i->get();
  else if (auto const number = parsed.too_large.find(value.where); number != parsed.too_large.end())
    value.data = number->second;
  else if (auto const* d = node.as_floating_point())
    value.data = d->get();
  else if (auto const* s = node.as_string())
    value.data = s->get();
  else if (auto const* array = node.as_array()) {
    Value::Array elements;
    for (auto const& element : *array) elements.push_back(value_of(element, source, parsed));
    value.data = std::move(elements);
  } else {
    value.data = Value::Other{node.is_table() ? "a table" : "a date or time"};
  }
  return value;
}

Section section_of(toml::key const& name, toml::node const& node, std::string const& source, Parsed const& parsed) {
  Section section{.name = std::string(name.str()), .where = where_of(name.source(), source)};
  auto const* table = node.as_table();
  section.is_table = table != nullptr;
  if (!section.is_table) return section;
  for (auto const& [key, value] : *table) {
    section.entries.push_back(
        {std::string(key.str()), where_of(key.source(), source), value_of(value, source, parsed)});
  }
  std::ranges::sort(section.entries, {}, &Entry::where);
  return section;
}

void set_where(Value& value, Where const& where) {
  value.where = where;
  if (auto* array = std::get_if<Value::Array>(&value.data))
    for (auto& element : *array) set_where(element, where);
}

std::string trimmed(std::string text) {
  auto const blank = " \t";
  text.erase(0, text.find_first_not_of(blank));
  text.erase(text.find_last_not_of(blank) + 1);
  return text;
}

/// toml++ makes a table in a table of each part of a key, and runs out of stack when it removes very many.
void refuse_deep_keys(std::string_view text, std::string const& source) {
  constexpr std::ptrdiff_t deepest = 100;
  unsigned number = 0;
  while (!text.empty()) {
    auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    auto const key = line.starts_with('[') ? line : line.substr(0, std::min(line.find('='), line.size()));
    ++number;
    bool const is_key = line.starts_with('[') || key.size() < line.size();
    if (is_key && std::ranges::count(key, '.') > deepest)
      throw Problem{{source, number, 1}, fmt::format("a key of more than {} parts", deepest)};
  }
}

/// The offset in a text of the letter at a line and column, from 1; the length of the text if there is none.
std::size_t place_in(std::string_view text, toml::source_position const& at) {
  std::size_t place = 0;
  for (unsigned line = 1; line < at.line && place < text.size(); ++line) place = text.find('\n', place) + 1;
  auto const begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  for (unsigned letters = 0; place < text.size(); ++place)
    if (begins(text[place]) && ++letters == at.column) return place;
  return text.size();
}

/// If that is what toml++ stopped at, notes the number that is too large and writes an infinite one over it, which
/// takes no more room.
bool take_too_large(std::string& text, std::string const& source, toml::parse_error const& error, Parsed& parsed) {
  auto const says = [&](char const* words) { return error.description().find(words) != std::string_view::npos; };
  char const* const beyond = says("is not representable in 64 bits")       ? "integers beyond 9223372036854775807"
                             : says("could not be interpreted as a value") ? "numbers beyond 1.8e+308"
                                                                           : nullptr;
  constexpr std::size_t most = 100;  // each is another look at the text
  if (beyond == nullptr || parsed.too_large.size() == most) return false;
  auto const end = place_in(text, error.source().begin);  // the error is behind the number
  auto const of_number = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("+-._", c) != nullptr;
  };
  auto begin = end;
  while (begin > 0 && of_number(text[begin - 1])) --begin;
  constexpr std::string_view infinite = "inf";
  if (end - begin < infinite.size()) return false;
  auto where = where_of(error.source(), source);
  where.column -= unsigned(end - begin);
  parsed.too_large[where] = {text.substr(begin, end - begin), beyond};
  text.replace(begin, end - begin, std::string(infinite).append(end - begin - infinite.size(), ' '));
  return true;
}

Parsed parse(std::string text, std::string const& source) {
  for (Parsed parsed;;) {
    try {
      parsed.root = toml::parse(std::string_view(text), std::string_view(source));
      return parsed;
    } catch (toml::parse_error const& error) {
      if (!take_too_large(text, source, error, parsed)) throw;
    }
  }
}

}  // namespace

std::vector<Section> parse_toml(std::string_view text, std::string const& source) {
  refuse_deep_keys(text, source);
  std::vector<Section> sections;
  try {
    auto const parsed = parse(std::string(text), source);
    for (auto const& [name, node] : parsed.root) sections.push_back(section_of(name, node, source, parsed));
  } catch (toml::parse_error const& error) {
    throw Problem{where_of(error.source(), source), shortened(error.description(), 240)};
  }
  std::ranges::sort(sections, {}, &Section::where);
  return sections;
}

std::vector<Section> read_toml_file(std::filesystem::path const& file) {
  auto const refuse = [&](int reason) {
    throw Problem{{file.string()}, "cannot be read: " + std::generic_category().message(reason)};
  };
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) refuse(EISDIR);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(errno);
  constexpr std::size_t most = 16'000'000;  // bytes; a device may have no end
  std::string text(most + 1, ' ');
  stream.read(text.data(), std::streamsize(text.size()));
  if (stream.bad()) refuse(EIO);
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > most) refuse(EFBIG);
  return parse_toml(text, file.string());
}

Section parse_override(std::string const& text, std::string const& source) {
  Where const where{source};
  auto const equals = text.find('=');
  auto const key = trimmed(text.substr(0, equals));
  auto const dot = key.find('.');
  if (equals == std::string::npos || dot == std::string::npos) {
    throw Problem{where, "'" + shortened(text) + "' is not of the form section.key=value"};
  }
  auto const right = trimmed(text.substr(equals + 1));
  Value value{.data = right, .where = where};
  try {
    auto const parsed = parse("value = " + right, "");
    if (parsed.root.size() == 1) value.data = value_of(*parsed.root.get("value"), "", parsed).data;
  } catch (toml::parse_error const&) {  // then it is a text without quotes
  }
  set_where(value, where);
  return {.name = key.substr(0, dot), .where = where, .entries = {{key.substr(dot + 1), where, value}}};
}

namespace {

// JSON as toml++ holds it: into a table under a name, or to the end of an array.
struct Insert {
  void operator()(toml::table& table, std::string const& name, Json const& json) const {
    std::visit([&](auto const& value) { table.insert_or_assign(name, converted(value)); }, json.data);
  }
  void operator()(toml::array& array, Json const& json) const {
    std::visit([&](auto const& value) { array.push_back(converted(value)); }, json.data);
  }
  template <class V>
  static V const& converted(V const& value) {
    return value;
  }
  static toml::array converted(Json::Array const& elements) {
    toml::array array;
    for (auto const& element : elements) Insert{}(array, element);
    return array;
  }
  static toml::table converted(Json::Object const& members) {
    toml::table table;
    for (auto const& [name, value] : members) Insert{}(table, name, value);
    return table;
  }
};

}  // namespace

std::string to_json(Json::Object const& object) {
  std::ostringstream text;
  text << toml::json_formatter{Insert::converted(object)} << '\n';
  return text.str();
}

}  // namespace scree::app
