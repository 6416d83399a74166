// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

/// The files of src/app/page, which the build copies into the library.
namespace scree::app::page_files {

extern std::string_view const page_html, colours_js, axes_js, particles_js, page_js;

}  // namespace scree::app::page_files
