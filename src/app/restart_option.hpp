// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/schema.hpp>
#include <scree/app/toml.hpp>

namespace scree::app::detail {

/// The option of a program that names the checkpoint to start from.
class RestartOption {
 public:
  /// `key`: see Program::restart; a program without that option cannot continue a run. `standard` has the default of
  /// the option, which means no checkpoint.
  RestartOption(OptionList const& list, std::string const& key, void const* standard) : standard_(standard) {
    for (auto const& option : list.options)
      if (key.empty() ? option.name == "restart_from" : option.key() == key) option_ = &option;
  }

  explicit operator bool() const { return option_ != nullptr; }
  std::string key() const { return option_ == nullptr ? "" : option_->key(); }
  /// The checkpoint that options name; empty: none.
  std::filesystem::path of(void const* options) const {
    if (option_ == nullptr || option_->text(options) == option_->text(standard_)) return {};
    auto const value = parse_override("a.b=" + option_->text(options)).entries.front().value;
    auto const* const path = std::get_if<std::string>(&value.data);
    return path == nullptr ? "" : *path;
  }
  void set(void* options, std::filesystem::path const& checkpoint) const {
    if (option_ != nullptr) option_->read(options, Value{.data = checkpoint.string(), .where = {}});
  }
  /// Sets the same checkpoint as in other options.
  void copy(void const* from, void* options) const {
    if (option_ == nullptr) return;
    option_->read(options, parse_override("a.b=" + option_->text(from)).entries.front().value);
  }

 private:
  void const* standard_;
  Option const* option_ = nullptr;
};

}  // namespace scree::app::detail
