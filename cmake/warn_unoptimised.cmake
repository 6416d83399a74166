# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Warns a project that uses scree and compiles without optimisation because it names no build type.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND NOT CMAKE_CXX_FLAGS MATCHES "-O[1-3sf]")
  message(WARNING "scree: no CMAKE_BUILD_TYPE, so that programs are compiled without optimisation and take many times as long. "
                  "Pass -DCMAKE_BUILD_TYPE=Release.")
endif()
