// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "codec.hpp"

#include <functional>

namespace support {

/// One option of a program whose options are a T: what it is called, what it takes, and how it gets into the T.
template <class T>
struct Option {
  std::string section, name;
  About about;
  std::string allowed;                         ///< in words
  std::function<void(T&, Value const&)> read;  ///< throws Problem
  std::function<std::string(T const&)> text;   ///< as TOML; empty: not given

  std::string key() const { return section + "." + name; }
};

/// A condition between options: `key` is the one to blame when it does not hold.
template <class T>
struct Rule {
  std::string key;
  std::function<bool(T const&)> holds;
  std::string message;  ///< what must hold; or when the option has an effect
};

/// The same with a message that depends on the options.
template <class T>
struct Complaint {
  std::string key;
  std::function<std::string(T const&)> about;  ///< empty: none
};

/// All options of a program, each declared once:
///
///     support::Schema<Options> schema;
///     schema.section("time", &Options::time, "How long")
///         .add("periods", &Time::periods, {.unit = "T", .range = {0, 1e4}, .meaning = "length of the run"});
///
/// Reading, checking, the table of options and the written case file all come from this declaration.
template <class T>
class Schema {
 public:
  template <class S>
  class InSection {
   public:
    InSection(Schema& schema, std::string name, S T::*part) : schema_(schema), name_(std::move(name)), part_(part) {}

    /// An option "section.name" kept in `member`, whose type and initialiser are the option's type and default.
    template <class V>
    InSection& add(std::string name, V S::*member, About about) {
      auto const allowed = Codec<V>::allowed(about);
      schema_.options_.push_back(
          {.section = name_,
           .name = std::move(name),
           .about = about,
           .allowed = allowed,
           .read = [=, part = part_](T& o, Value const& v) { o.*part.*member = Codec<V>::read(v, about); },
           .text = [=, part = part_](T const& o) { return Codec<V>::text(o.*part.*member); }});
      return *this;
    }

   private:
    Schema& schema_;
    std::string name_;
    S T::*part_;
  };

  template <class S>
  InSection<S> section(std::string name, S T::*part, std::string meaning) {
    sections_.emplace_back(name, std::move(meaning));
    return InSection<S>(*this, std::move(name), part);
  }

  /// Refuses options for which `rule.holds` is false.
  void require(Rule<T> rule) { rules_.push_back(std::move(rule)); }
  /// Refuses options for which `complaint.about` has words.
  void complain(Complaint<T> complaint) { complaints_.push_back(std::move(complaint)); }
  /// Tells the user when an option was changed from its default although `rule.holds` is false: it does nothing then.
  void only_when(Rule<T> rule) { effects_.push_back(std::move(rule)); }

  std::vector<Option<T>> const& options() const { return options_; }
  std::vector<std::pair<std::string, std::string>> const& sections() const { return sections_; }  ///< name, meaning
  std::vector<Rule<T>> const& rules() const { return rules_; }
  std::vector<Rule<T>> const& effects() const { return effects_; }
  std::vector<Complaint<T>> const& complaints() const { return complaints_; }

  /// The option of that name, or nullptr.
  Option<T> const* find(std::string const& section, std::string const& name) const {
    for (auto const& option : options_) {
      if (option.section == section && option.name == name) return &option;
    }
    return nullptr;
  }
  std::vector<std::string> section_names() const {
    std::vector<std::string> names;
    for (auto const& section : sections_) names.push_back(section.first);
    return names;
  }
  std::vector<std::string> names_in(std::string const& section) const {
    std::vector<std::string> names;
    for (auto const& option : options_) {
      if (option.section == section) names.push_back(option.name);
    }
    return names;
  }

 private:
  std::vector<std::pair<std::string, std::string>> sections_;
  std::vector<Option<T>> options_;
  std::vector<Rule<T>> rules_, effects_;
  std::vector<Complaint<T>> complaints_;
};

}  // namespace support
