# SPDX-License-Identifier: GPL-3.0-or-later
# rigor_add_notes: every step of some notes becomes a test of CTest.
#
#   rigor_add_notes(TARGET NOTES...
#     [SIDECAR FILE]             directives beside the notes; only with one file of notes
#     [STRICT]                   warnings are failures
#     [SKIP_OPEN]                what is undecided or not understood is skipped, not a failure
#     [WORKING_DIRECTORY FOLDER] messages have paths as seen from there; without it, full ones
#     [TIMEOUT SECONDS]          for checking one file
#     [LABELS LABEL...])         of the tests; without it, TARGET
#
# A test is named after the notes, as seen from FOLDER, or else from the current source folder, without the
# extension, and after the step's tag: `notes/euler (6) step 2`. A step without a tag is named after its line. `(whole file)` is about
# what belongs to no step. The notes are checked once, by the test `(checked)` before them; ctest finds new
# steps when it starts, if the notes have changed.
#
# TARGET checks the notes when it is built, and prints the report. It is not part of `all`.
include_guard()
set(_rigor_package_folder ${CMAKE_CURRENT_LIST_DIR})

function(rigor_add_notes target)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "STRICT;SKIP_OPEN" "SIDECAR;WORKING_DIRECTORY;TIMEOUT" "LABELS")
  set(where "rigor_add_notes(${target})")
  if(NOT arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${where}: no notes are given")
  endif()
  if(DEFINED arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "${where}: nothing stands behind ${arg_KEYWORDS_MISSING_VALUES}")
  endif()
  list(LENGTH arg_UNPARSED_ARGUMENTS count)
  if(DEFINED arg_SIDECAR AND count GREATER 1)
    message(FATAL_ERROR "${where}: SIDECAR belongs to one file, and ${count} are given")
  endif()
  if(DEFINED arg_TIMEOUT AND NOT arg_TIMEOUT MATCHES "^[0-9]+([.][0-9]+)?$")
    message(FATAL_ERROR "${where}: TIMEOUT `${arg_TIMEOUT}` is no number of seconds")
  endif()

  set(skip_code -1)
  if(arg_SKIP_OPEN)
    set(skip_code 2) # the exit code of `rigor case`
  endif()
  set(options "")
  if(arg_STRICT)
    list(APPEND options --strict)
  endif()
  if(DEFINED arg_SIDECAR)
    get_filename_component(sidecar "${arg_SIDECAR}" ABSOLUTE)
    _rigor_require_file("${where}" "${sidecar}")
    list(APPEND options "--sidecar=${sidecar}")
  endif()
  set(folder "${CMAKE_CURRENT_SOURCE_DIR}")
  if(DEFINED arg_WORKING_DIRECTORY)
    get_filename_component(folder "${arg_WORKING_DIRECTORY}" ABSOLUTE)
  endif()
  if(NOT DEFINED arg_LABELS)
    set(arg_LABELS ${target})
  endif()

  set(paths "")
  set(number 0)
  foreach(notes IN LISTS arg_UNPARSED_ARGUMENTS)
    get_filename_component(path "${notes}" ABSOLUTE)
    _rigor_require_file("${where}" "${path}")
    _rigor_name_notes(name "${folder}" "${path}" ${target})
    if(DEFINED arg_WORKING_DIRECTORY)
      file(RELATIVE_PATH path "${folder}" "${path}")
    endif()
    list(APPEND paths "${path}")
    math(EXPR number "${number} + 1")
    _rigor_add_listing(${target} ${number})
  endforeach()

  add_custom_target(${target}
    COMMAND "$<TARGET_FILE:rigor::rigor>" check ${options} -- ${paths}
    WORKING_DIRECTORY "${folder}"
    COMMENT "Checking the notes of ${target}"
    VERBATIM USES_TERMINAL)
endfunction()

function(_rigor_require_file where path)
  get_source_file_property(generated "${path}" GENERATED)
  if(NOT generated AND (NOT EXISTS "${path}" OR IS_DIRECTORY "${path}"))
    message(FATAL_ERROR "${where}: ${path} is no file")
  endif()
endfunction()

# What the tests of the notes begin with: no two files of a project have the same.
function(_rigor_name_notes result folder path target)
  file(RELATIVE_PATH name "${folder}" "${path}")
  if(name MATCHES "^[.][.]/")
    get_filename_component(name "${path}" NAME)
  endif()
  string(REGEX REPLACE "([^/])[.][^./]*$" "\\1" stem "${name}")
  get_property(used GLOBAL PROPERTY RIGOR_NAMES_OF_NOTES)
  foreach(candidate IN ITEMS "${stem}" "${name}" "${target}: ${name}" "${target}: ${path}")
    set(name "${candidate}")
    if(NOT name IN_LIST used)
      break()
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY RIGOR_NAMES_OF_NOTES "${name}")
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

# Writes what ctest includes for one file of notes. Sees the variables of rigor_add_notes.
macro(_rigor_add_listing target number)
  set(stem "${CMAKE_CURRENT_BINARY_DIR}/rigor/${target}-${number}")
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/rigor")
  set(settings "# made by rigor_add_notes; ctest includes it\n")
  foreach(setting IN ITEMS
      "program=$<TARGET_FILE:rigor::rigor>" "notes=${path}" "name=${name}" "folder=${folder}"
      "settings=${stem}.cmake" "listing=${stem}-steps.cmake" "results=${stem}.json"
      "fixture=rigor ${target} ${number}" "labels=${arg_LABELS}" "timeout=${arg_TIMEOUT}" "skip_code=${skip_code}"
      "options=${options}")
    string(REGEX MATCH "^([a-z_]+)=(.*)$" _ "${setting}")
    string(APPEND settings "set(rigor_${CMAKE_MATCH_1} [==[${CMAKE_MATCH_2}]==])\n")
  endforeach()
  string(APPEND settings "include([==[${_rigor_package_folder}/rigorListSteps.cmake]==])\n")
  file(GENERATE OUTPUT "${stem}.cmake" CONTENT "${settings}")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${stem}.cmake")
endmacro()
