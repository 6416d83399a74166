// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// The bodies of functions that do not depend on a formulation are in files *.ipp next to their headers. A program that
// uses the headers alone compiles them as inline functions; SCREE_COMPILED, which the CMake target scree::compiled
// defines, says that they are in its library. The library also holds the instances of templates that headers declare
// with SCREE_INSTANCE; sources in src/compiled make them.
#ifdef SCREE_COMPILED
#define SCREE_BODY
#ifndef SCREE_INSTANCE
#define SCREE_INSTANCE extern template
#endif
#else
#define SCREE_BODY inline
#endif
