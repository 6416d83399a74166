// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "codec.hpp"

#include <concepts>
#include <functional>
#include <map>

namespace scree::app {

/// One option of a program: its name, its allowed values, and its offset in the struct of options.
struct Option {
  std::string section, name;
  About about;
  std::string allowed;                                                        ///< allowed values in words
  std::ptrdiff_t at;                                                          ///< bytes from the start of the struct
  void (*read_member)(void* member, Value const& value, About const& about);  ///< sets the member; throws Problem
  std::string (*text_of_member)(void const* member);                          ///< the member as TOML

  /// Returns the key of the option, "section.name".
  std::string key() const { return section + "." + name; }
  /// Sets the option in a struct. Throws Problem if the value has another type or is out of range.
  void read(void* options, Value const& value) const { read_member(static_cast<char*>(options) + at, value, about); }
  /// Returns the value of the option in a struct as TOML, or an empty string if it is not given.
  std::string text(void const* options) const { return text_of_member(static_cast<char const*>(options) + at); }
};

/// A condition on options of type T. `key` is the option to blame if the condition does not hold.
template <class T>
struct Rule {
  std::string key;
  std::function<bool(T const&)> holds;  ///< whether the options satisfy the condition
  std::string message;                  ///< the condition that must hold, or under which the option has an effect
};

/// A condition on options whose message depends on their values. `key` is the option to blame.
template <class T>
struct Complaint {
  std::string key;
  std::function<std::string(T const&)> about;  ///< the message; empty: none
};

/// All options of a program, independent of the type of their struct.
struct OptionList {
  /// A check of options that depend on one another.
  struct Check {
    std::string key;
    std::function<std::string(void const*)> about;  ///< the message about options; empty: none
  };
  std::vector<std::pair<std::string, std::string>> sections;  ///< name, meaning
  std::vector<Option> options;
  std::vector<Check> rules, complaints;        ///< complaints are checked only if all rules hold
  std::vector<Check> effects;                  ///< notes about settings without effect
  std::map<std::string, std::string> renamed;  ///< keys of earlier versions, with the current keys

  /// Returns the option with a name, which may be a name from an earlier version, or nullptr if there is none.
  Option const* find(std::string const& section, std::string const& name) const;
  /// Returns the names of all sections.
  std::vector<std::string> section_names() const;
  /// Returns the names of the options of a section.
  std::vector<std::string> names_in(std::string const& section) const;
};

/// The declaration of all options of a program, each option once:
///
///     app::Schema<Options> schema;
///     schema.section("time", &Options::time, "How long")
///         .add("periods", &Time::periods, {.unit = "T", .range = {0, 1e4}, .meaning = "length of the run"});
///
/// Reading, checking, the table of options and the case file that is written all follow from this declaration.
template <class T>
class Schema {
 public:
  template <class S>
  class InSection {
   public:
    using Part = S T::*;
    /// Creates an object that adds options of the struct `part`, a member of the options, under the name of a section.
    InSection(Schema& schema, std::string name, Part part) : schema_(schema), name_(std::move(name)), part_(part) {}

    /// Adds an option "section.name" and returns this object. The type and the initialiser of `member` are the type and
    /// the default of the option.
    template <class V>
    InSection& add(std::string name, V S::*member, About about) {
      auto allowed = Codec<V>::allowed(about);
      schema_.list_.options.push_back({name_, std::move(name), std::move(about), std::move(allowed),
                                       schema_.offset_of(schema_.standard_.*part_.*member), read_as<V>, text_as<V>});
      return *this;
    }

    /// Adds an option for a parameter of a model, which defines the unit, range and meaning; a program may narrow the
    /// range:
    ///     .add("mu_s", &Material::mu_s, parameter_of<&MuOfI<>::mu_s>.within(0.01, 2))
    template <class V, std::same_as<ParameterAbout> P>  // not a list in braces
    InSection& add(std::string name, V S::*member, P const& parameter, std::string unset = {}) {
      About about{.unit = parameter.unit, .range = parameter.range, .meaning = parameter.meaning, .unset = {}};
      about.unset = std::move(unset);
      return add(std::move(name), member, std::move(about));
    }
    /// Adds all parameters of the struct of this section, which must be a model, with their names, ranges and defaults.
    /// Returns this object.
    InSection& add_parameters() {
      static_assert(scree::detail::HasParameters<S>, "the struct of this section is not a model with parameters()");
      for (auto const& each : S::parameters()) {
        ParameterAbout const& parameter = each;
        if (each.number != nullptr) add(each.name, each.number, parameter);
        if (each.count != nullptr) add(each.name, each.count, parameter);
        if constexpr (scree::detail::has_vectors<S>()) {
          if (each.in_plane != nullptr) add(each.name, each.in_plane, parameter);
          if (each.in_space != nullptr) add(each.name, each.in_space, parameter);
        }
      }
      return *this;
    }

   private:
    Schema& schema_;
    std::string name_;
    Part part_;
  };

  /// Adds a section whose options are members of the struct `part`, and returns an object that adds these options.
  template <class S>
  InSection<S> section(std::string name, S T::*part, std::string meaning) {
    list_.sections.emplace_back(name, std::move(meaning));
    return InSection<S>(*this, std::move(name), part);
  }

  /// Rejects options for which `rule.holds` is false.
  void require(Rule<T> rule) { list_.rules.push_back(check(std::move(rule))); }
  /// Rejects options for which `complaint.about` returns a message.
  void complain(Complaint<T> complaint) {
    list_.complaints.push_back({std::move(complaint.key), [about = std::move(complaint.about)](void const* options) {
                                  return about(*static_cast<T const*>(options));
                                }});
  }
  /// Tells the user if an option differs from its default although `rule.holds` is false, so that it has no effect.
  void only_when(Rule<T> rule) { list_.effects.push_back(check(std::move(rule))); }

  /// Accepts the key that an option had in earlier versions, whose section must exist, and tells the user the current
  /// key.
  void rename(std::string const& earlier, std::string const& key) { list_.renamed[earlier] = key; }

  /// Returns all options, sections and rules.
  OptionList const& list() const { return list_; }
  /// Returns all options in the order in which they were added.
  std::vector<Option> const& options() const { return list_.options; }
  /// Returns the default values of all options.
  T const& standard() const { return standard_; }

 private:
  template <class V>
  static void read_as(void* member, Value const& value, About const& about) {
    *static_cast<V*>(member) = Codec<V>::read(value, about);
  }
  template <class V>
  static std::string text_as(void const* member) {
    return Codec<V>::text(*static_cast<V const*>(member));
  }
  static OptionList::Check check(Rule<T> rule) {
    return {std::move(rule.key), [holds = std::move(rule.holds), message = std::move(rule.message)](void const* o) {
              return holds(*static_cast<T const*>(o)) ? std::string() : message;
            }};
  }
  std::ptrdiff_t offset_of(auto const& member) const {
    return reinterpret_cast<char const*>(&member) - reinterpret_cast<char const*>(&standard_);
  }

  T standard_{};
  OptionList list_;
};

}  // namespace scree::app
