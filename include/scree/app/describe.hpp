// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"

namespace scree::app {

/// Returns the table of all options in Markdown: key, unit, default, allowed values, meaning.
std::string option_table(OptionList const& list, void const* standard);
template <class T>
std::string option_table(Schema<T> const& schema) {
  return option_table(schema.list(), &schema.standard());
}

/// Returns the options as a commented case file, from which read_case() reads the same options.
std::string case_text(OptionList const& list, void const* options);
template <class T>
std::string case_text(Schema<T> const& schema, T const& options) {
  return case_text(schema.list(), &options);
}

}  // namespace scree::app
