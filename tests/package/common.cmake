# SPDX-License-Identifier: GPL-3.0-or-later
# For the scripts of this folder: WORK, BUILD and SOURCE are set.
cmake_minimum_required(VERSION 3.25)
set(PREFIX ${WORK}/moved) # where it is installed

# Runs a command, keeps what it prints in `output`, and demands that its exit code matches `code`.
function(run code)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output
    WORKING_DIRECTORY ${WORK} COMMAND_ECHO STDOUT)
  if(NOT result MATCHES "^(${code})$")
    message(FATAL_ERROR "ended with ${result}, expected ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# `text` must stand in `output`.
function(expect text)
  string(FIND "${output}" "${text}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "`${text}` is not in:\n${output}")
  endif()
endfunction()

# What ctest counts as failed must be these, in any order.
function(expect_failed)
  string(REGEX MATCHALL "\n[ \t]*[0-9]+ - [^\n]* \\((Failed|Not Run|Timeout)\\)" lines "${output}")
  set(failed "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^\n[ \t]*[0-9]+ - (.*) \\([A-Za-z ]+\\)$" "\\1" name "${line}")
    list(APPEND failed "${name}")
  endforeach()
  list(SORT failed)
  set(expected ${ARGN})
  list(SORT expected)
  if(NOT failed STREQUAL expected)
    message(FATAL_ERROR "failed: ${failed}\nexpected: ${expected}\n${output}")
  endif()
endfunction()

# Replaces one text in a file; it must be there.
function(replace file old new)
  file(READ ${file} text)
  string(FIND "${text}" "${old}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "`${old}` is not in ${file}")
  endif()
  string(REPLACE "${old}" "${new}" text "${text}")
  file(WRITE ${file} "${text}")
endfunction()
