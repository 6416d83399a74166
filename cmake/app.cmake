# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree::app, for programs with case files (docs/case_programs.md): the headers in include/scree/app, and a small library
# compiled from src/app. No header includes CLI11 or toml++, and nvcc does not accept toml++ (its issue 213), so the host compiler
# compiles it also in a CUDA build. toml++ is compiled into the library (2 s), because its own library is not everywhere.

find_package(CLI11 CONFIG QUIET)
find_package(tomlplusplus CONFIG QUIET)
if(NOT TARGET scree_io OR NOT CLI11_FOUND OR NOT tomlplusplus_FOUND)
  message(FATAL_ERROR "scree::app and scree's examples need HDF5, CLI11 and toml++. On Debian or Ubuntu: apt-get install "
                      "libhdf5-dev libcli11-dev libtomlplusplus-dev; or configure with -DSCREE_APP=OFF and "
                      "-DSCREE_BUILD_EXAMPLES=OFF.")
endif()

file(GLOB SCREE_APP_SOURCES CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/app/*.cpp")
# The page of --preview, which examples/view writes too, as texts in a source file.
function(scree_write_page_files source)
  set(texts "")
  foreach(part IN ITEMS page.html colours.js axes.js particles.js page.js)
    set(path "${PROJECT_SOURCE_DIR}/src/app/page/${part}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    file(READ "${path}" text)
    string(REPLACE "." "_" name "${part}")
    string(APPEND texts "std::string_view const ${name} = R\"scree(${text})scree\";\n")
  endforeach()
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
#include "@PROJECT_SOURCE_DIR@/src/app/page_files.hpp"
namespace scree::app::page_files {
@texts@}  // namespace scree::app::page_files
]])
endfunction()
set(page_files "${PROJECT_BINARY_DIR}/scree_app/page_files.cpp")
scree_write_page_files("${page_files}")
add_library(scree_app STATIC ${SCREE_APP_SOURCES} "${page_files}")
add_library(scree::app ALIAS scree_app)
# In batches, which takes half of the processor time: most of it is spent on the headers of Kokkos and fmt.
set_target_properties(scree_app PROPERTIES EXPORT_NAME app POSITION_INDEPENDENT_CODE ON UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
target_link_libraries(scree_app PUBLIC scree_io ${scree_for_programs}
  PRIVATE $<BUILD_INTERFACE:CLI11::CLI11>
          $<BUILD_INTERFACE:$<TARGET_NAME_IF_EXISTS:scree_own_headers>>)
target_include_directories(scree_app SYSTEM PRIVATE
  $<TARGET_PROPERTY:tomlplusplus::tomlplusplus,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_definitions(scree_app PRIVATE TOML_HEADER_ONLY=1)
target_sources(scree_app PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${app_headers})
if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
  target_compile_options(scree_app PRIVATE --host-only)
endif()
