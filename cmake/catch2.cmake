# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Catch2 3 for the tests: an installed copy, else built once into the per-user cache.

find_package(Catch2 3.4 CONFIG QUIET)
if(NOT Catch2_FOUND)
  scree_fetch(archive NAME Catch2 VERSION 3.7.1
    URL https://github.com/catchorg/Catch2/archive/refs/tags/v3.7.1.tar.gz
    SHA256 c991b247a1a0d7bb9c39aa35faf0fe9e19764213f28ffba3109388e62ee0269c
    DEBIAN pool/main/c/catch2/catch2_3.7.1.orig.tar.gz
    DEBIAN_SHA256 c991b247a1a0d7bb9c39aa35faf0fe9e19764213f28ffba3109388e62ee0269c)
  scree_compiler_tag(tag "${SCREE_HOST_CXX}")
  scree_build_once(catch2_prefix NAME "catch2-3.7.1-${tag}" ARCHIVE "${archive}" CXX "${SCREE_HOST_CXX}"
    OPTIONS -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_STANDARD=20 -DCATCH_INSTALL_DOCS=OFF -DCMAKE_INSTALL_LIBDIR=lib)
  find_package(Catch2 3.4 CONFIG REQUIRED PATHS "${catch2_prefix}" NO_DEFAULT_PATH)
endif()
