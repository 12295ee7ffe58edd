# SPDX-License-Identifier: GPL-3.0-or-later
# Writes one CTest case a step of the notes, and one before them that checks the notes for all of these.
#
#   cmake -D RIGOR=<program> -D STEP_TEST=<program> -D NOTES=<file> -D LISTING=<to write> -P list_steps.cmake
#
# Runs from the top of the repository; NOTES is a path from there. What the verdicts are does not matter here.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${RIGOR} check --json --color never ${NOTES}
  OUTPUT_VARIABLE json ERROR_VARIABLE errors RESULT_VARIABLE exit_code)
if(NOT exit_code MATCHES "^[012]$")
  message(FATAL_ERROR "`rigor check --json ${NOTES}` ended with ${exit_code}\n${errors}${json}")
endif()
string(JSON file_count ERROR_VARIABLE not_json LENGTH "${json}" files)
if(not_json)
  message(FATAL_ERROR
    "`rigor check --json ${NOTES}` did not print the expected JSON: ${not_json}\n${errors}${json}")
endif()
if(NOT file_count EQUAL 1)
  message(FATAL_ERROR "`rigor check --json ${NOTES}` reported ${file_count} files")
endif()

string(JSON steps GET "${json}" files 0 steps)
string(JSON count LENGTH "${steps}")
set(results ${LISTING}.json)
set(checked "${NOTES}: checked")
set(listing
  "add_test([==[${checked}]==] [==[${STEP_TEST}]==] check [==[${NOTES}]==] [==[${results}]==])
set_tests_properties([==[${checked}]==] PROPERTIES LABELS derivations FIXTURES_SETUP [==[${NOTES}]==]
  WORKING_DIRECTORY [==[${CMAKE_CURRENT_BINARY_DIR}]==])
")
set(names "")
set(index 0)
while(index LESS count)
  string(JSON step GET "${steps}" ${index})
  string(JSON line GET "${step}" line)
  string(JSON column GET "${step}" column)
  string(JSON tag ERROR_VARIABLE no_tag GET "${step}" tag)

  # The tag as it is printed beside the equation, without what CTest or CMake would read in a name.
  string(REGEX REPLACE "^\\((.*)\\)$" "\\1" tag "${tag}")
  string(REGEX REPLACE "[][;\\\"\n]" "" tag "${tag}")
  if(no_tag OR tag STREQUAL "")
    set(name "${NOTES}:${line}:${column}")
  else()
    set(name "${NOTES}:${line}:(${tag})")
    if(name IN_LIST names) # a chain on one line
      string(APPEND name ":${column}")
    endif()
  endif()
  set(unique "${name}")
  set(copy 1)
  while(unique IN_LIST names)
    math(EXPR copy "${copy} + 1")
    set(unique "${name}#${copy}")
  endwhile()
  list(APPEND names "${unique}")

  string(APPEND listing
    "add_test([==[${unique}]==] [==[${STEP_TEST}]==] step [==[${results}]==] ${line} ${column})
set_tests_properties([==[${unique}]==] PROPERTIES LABELS derivations FIXTURES_REQUIRED [==[${NOTES}]==])
")
  math(EXPR index "${index} + 1")
endwhile()
if(count EQUAL 0)
  message(WARNING "${NOTES} has no step")
endif()
file(WRITE ${LISTING} "${listing}")
