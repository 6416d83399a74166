# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# cmake -DSOURCE=case.cpp -DCOMMANDS=compile_commands.json [-DMUST_COMPILE=ON] [-DBRIEF=ON] -P check.cmake

cmake_minimum_required(VERSION 3.24)

# Sets <result> to the command that checks SOURCE without writing an object. The file of commands has a line for each member; CMake
# takes long to parse it as a whole.
function(compile_command result)
  cmake_path(GET SOURCE FILENAME name)
  file(STRINGS "${COMMANDS}" lines REGEX "\"(command|file)\": .*/${name}")
  foreach(line IN LISTS lines) # the file follows its command
    string(REGEX REPLACE ",$" "" line "${line}")
    string(JSON member MEMBER "{${line}}" 0)
    string(JSON ${member} GET "{${line}}" ${member})
    if(member STREQUAL "file" AND file STREQUAL SOURCE)
      string(REGEX REPLACE " -o [^ ]+" " -fsyntax-only" command "${command}")
      set(${result} "${command}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${SOURCE} is not in ${COMMANDS}; configure again.")
endfunction()

compile_command(command)
if(BRIEF) # Clang lists the files between a header and the precompiled one, which users do not have
  string(REGEX REPLACE " -Winvalid-pch( -Xclang [^ ]+)+" "" command "${command}")
endif()
cmake_path(GET COMMANDS PARENT_PATH build) # paths in precompiled headers may be relative to it
execute_process(COMMAND sh -c "${command}" WORKING_DIRECTORY "${build}" RESULT_VARIABLE code
                OUTPUT_VARIABLE output ERROR_VARIABLE output)

if(MUST_COMPILE)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "With FIXED these cases must compile, and one did not: ${SOURCE}\n${output}")
  endif()
  return()
endif()
file(STRINGS "${SOURCE}" expected REGEX "^// expected: ")
list(LENGTH expected count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "${SOURCE} needs exactly one line '// expected: <regular expression>'.")
endif()
string(REPLACE "// expected: " "" expected "${expected}")
if(code EQUAL 0)
  message(FATAL_ERROR "This compiled, and must not: ${SOURCE}")
elseif(NOT output MATCHES "${expected}")
  message(FATAL_ERROR "The compiler refused ${SOURCE}, but its output does not match\n  ${expected}\nIt says\n${output}")
endif()

# The sentence is the first error, and not much follows it.
if(BRIEF)
  string(REPLACE ";" "," lines "${output}")
  string(REPLACE "[" "(" lines "${lines}") # CMake keeps what is in brackets together
  string(REPLACE "]" ")" lines "${lines}")
  string(REGEX REPLACE "\n$" "" lines "${lines}")
  string(REPLACE "\n" ";" lines "${lines}")
  list(LENGTH lines number)
  list(FILTER lines INCLUDE REGEX " error: ")
  list(GET lines 0 first)
  if(NOT first MATCHES "${expected}")
    message(FATAL_ERROR "${SOURCE} is refused for another reason first:\n  ${first}\nexpected was\n  ${expected}")
  elseif(number GREATER 40)
    message(FATAL_ERROR "The compiler prints ${number} lines about ${SOURCE}, more than 40: what follows the mistake should not be "
                        "compiled. It says\n${output}")
  endif()
endif()
