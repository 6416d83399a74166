# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Packages of the applications for those who do not compile: `cpack --config build/openmp/CPackConfig.cmake` makes a .deb, which
# takes libraries from the packages of the system, and a .tar.xz that brings all but glibc. They contain the applications that
# were built, the cases of all, and the Python programs that make files for cases and draw results. `quickstart.sh pack` builds all applications first.
#
# A .deb that was built on Debian 12 runs on Debian 13 and Ubuntu 24.04 too, because applications contain HDF5
# (static_hdf5.cmake) and toml++, whose packages have other names there.

get_property(programs GLOBAL PROPERTY SCREE_APPLICATIONS)
set(place lib/scree) # not bin: their names, `drum` and the like, are those of others too
set(files "")
foreach(program IN LISTS programs)
  install(TARGETS ${program} RUNTIME DESTINATION ${place} COMPONENT applications EXCLUDE_FROM_ALL OPTIONAL)
  get_target_property(folder ${program} SOURCE_DIR)
  install(DIRECTORY "${folder}/" DESTINATION share/scree/${program} COMPONENT applications EXCLUDE_FROM_ALL
          FILES_MATCHING PATTERN "*.toml" PATTERN "*.py" PATTERN "reference/*" PATTERN "figures" EXCLUDE)
  string(APPEND files " \"$<TARGET_FILE:${program}>\"")
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/view" DESTINATION share/scree COMPONENT applications EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/app/page/" DESTINATION share/scree/view/page_files COMPONENT applications
        EXCLUDE_FROM_ALL)
file(CONFIGURE OUTPUT scree @ONLY CONTENT [[
#!/bin/sh
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# scree APPLICATION [CASE.toml] [OPTIONS]: runs one of the applications of scree. Without arguments it lists them.
# scree view OUT [OPTIONS]: shows the results of a run.
here=$(dirname "$(readlink -f "$0")")/..
if [ "${1-}" = view ]; then
  shift
  export PYTHONDONTWRITEBYTECODE=1
  command -v python3 >/dev/null || { echo "scree view needs python3 with h5py and matplotlib" >&2; exit 1; }
  exec python3 "$here/share/scree/view" "$@"
fi
if [ $# = 0 ] || [ "$1" = --help ] || ! [ -x "$here/lib/scree/$1" ] || [ -d "$here/lib/scree/$1" ]; then
  echo "usage: scree APPLICATION [CASE.toml] [OPTIONS]; scree APPLICATION --help tells the options"
  echo "       scree view OUT [OPTIONS]; scree view --help tells the options"
  for program in "$here"/lib/scree/*; do
    [ -d "$program" ] || echo "  $(basename "$program"): cases in $(readlink -f "$here/share/scree/$(basename "$program")")"
  done
  [ $# = 0 ] || [ "$1" = --help ]
  exit
fi
program=$1
shift
if [ -d "$here/lib/scree/libraries" ]; then
  export LD_LIBRARY_PATH="$(readlink -f "$here/lib/scree/libraries")${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
fi
export OMP_PROC_BIND="${OMP_PROC_BIND-spread}" OMP_PLACES="${OMP_PLACES-threads}"
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY-passive}" # threads that spin stop each other on a busy machine
exec "$here/lib/scree/$program" "$@"
]])
install(PROGRAMS "${CMAKE_CURRENT_BINARY_DIR}/scree" DESTINATION bin COMPONENT applications EXCLUDE_FROM_ALL)
file(CONFIGURE OUTPUT copyright @ONLY CONTENT [[
scree, Apache-2.0 WITH LLVM-exception: see LICENSE beside this file. The applications contain code of Kokkos (Apache-2.0 WITH
LLVM-exception) and {fmt} (MIT), and code of the libraries whose licences are in licences/. The sources of Eigen (MPL-2.0) are
those of its release, unchanged: https://eigen.tuxfamily.org.
]])
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/copyright" "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        DESTINATION share/doc/scree COMPONENT applications EXCLUDE_FROM_ALL)

# What applications contain is told by a file of each; its licence is that of the package of the system that owns the file.
set(contained "")
if(TARGET scree_static_hdf5)
  get_target_property(contained scree_static_hdf5 INTERFACE_LINK_LIBRARIES)
  list(FILTER contained INCLUDE REGEX "/")
endif()
foreach(library IN ITEMS Eigen3::Eigen CLI11::CLI11 tomlplusplus::tomlplusplus)
  string(REGEX REPLACE "::.*" "" name "${library}")
  set(header_Eigen3 Eigen/Core)
  set(header_CLI11 CLI/App.hpp)
  set(header_tomlplusplus toml++/toml.h)
  get_target_property(folders ${library} INTERFACE_INCLUDE_DIRECTORIES)
  find_file(SCREE_HEADER_${name} ${header_${name}} HINTS ${folders})
  mark_as_advanced(SCREE_HEADER_${name})
  list(APPEND contained "${SCREE_HEADER_${name}}")
endforeach()
file(CONFIGURE OUTPUT add_licence.cmake @ONLY CONTENT [[
# Copies the licence of a file of the system below a root.
function(add_licence root file)
  execute_process(COMMAND dpkg -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET)
  if(NOT owner)
    file(REAL_PATH "${file}" real)
    execute_process(COMMAND dpkg -S "${real}" OUTPUT_VARIABLE owner ERROR_QUIET)
  endif()
  string(REGEX MATCH "^[^:]+" owner "${owner}")
  if(NOT owner OR NOT EXISTS "/usr/share/doc/${owner}/copyright")
    message(FATAL_ERROR "no licence of ${file} is found")
  endif()
  file(MAKE_DIRECTORY "${root}/share/doc/scree/licences")
  file(COPY_FILE "/usr/share/doc/${owner}/copyright" "${root}/share/doc/scree/licences/${owner}")
endfunction()
]])
file(CONFIGURE OUTPUT licences.cmake @ONLY CONTENT [[
include("@CMAKE_CURRENT_BINARY_DIR@/add_licence.cmake")
foreach(file IN ITEMS @contained@)
  add_licence("$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}" "${file}")
endforeach()
]])
install(SCRIPT "${CMAKE_CURRENT_BINARY_DIR}/licences.cmake" COMPONENT applications EXCLUDE_FROM_ALL)

# All libraries of the applications but those of glibc.
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/bring_libraries.cmake" CONTENT "
include(\"${CMAKE_CURRENT_BINARY_DIR}/add_licence.cmake\")
set(built \"\")
foreach(program IN ITEMS${files})
  if(EXISTS \"\${program}\")
    list(APPEND built \"\${program}\")
  endif()
endforeach()
set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES \${built} RESOLVED_DEPENDENCIES_VAR libraries UNRESOLVED_DEPENDENCIES_VAR missing
     POST_EXCLUDE_REGEXES \"/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util))[.]so\")
if(missing)
  message(FATAL_ERROR \"libraries are missing: \${missing}\")
endif()
foreach(library IN LISTS libraries)
  file(INSTALL \"\${library}\" DESTINATION \"\${root}/${place}/libraries\" FOLLOW_SYMLINK_CHAIN)
  add_licence(\"\${root}\" \"\${library}\")
endforeach()
")
install(SCRIPT "${CMAKE_CURRENT_BINARY_DIR}/bring_libraries.cmake" COMPONENT libraries EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR "DEB;TXZ")
set(CPACK_PACKAGE_NAME scree)
set(CPACK_PACKAGE_CONTACT "The scree authors")
set(CPACK_PACKAGE_VENDOR "The scree authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Applications of scree: smoothed particle hydrodynamics of granular matter")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGE_FILE_NAME "scree-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL applications libraries)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib") # for `scree view` and plot.py
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/packages_of_generator.cmake")
include(CPack)
