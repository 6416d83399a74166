// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// Functions that do not depend on a formulation are defined in *.ipp files next to their headers. A header-only program
// compiles them as inline functions. If SCREE_COMPILED is defined, as it is by the CMake target scree::compiled, these
// functions come from that library. The library also contains the template instances that headers declare with
// SCREE_INSTANCE; sources in src/compiled define these instances.
#ifdef SCREE_COMPILED
#define SCREE_BODY
#ifndef SCREE_INSTANCE
#define SCREE_INSTANCE extern template
#endif
#else
#define SCREE_BODY inline
#endif
