# SPDX-License-Identifier: GPL-3.0-or-later
# What ctest does for one file of notes before it runs anything: adds the tests of its steps, and lists them
# first if that was not done since the notes last changed. rigor_add_notes sets the variables.
cmake_policy(VERSION 3.16...3.25)

set(rigor_stale OFF)
set(rigor_listed OFF)
if(NOT EXISTS "${rigor_listing}" OR "${rigor_settings}" IS_NEWER_THAN "${rigor_listing}")
  set(rigor_stale ON)
else()
  include("${rigor_listing}")
endif()
if(rigor_stale)
  set(rigor_limit "")
  if(rigor_timeout)
    set(rigor_limit TIMEOUT ${rigor_timeout})
  endif()
  execute_process(COMMAND "${rigor_program}" cases "--name=${rigor_name}"
      --into "${rigor_results}" --ctest "${rigor_listing}" ${rigor_options} -- "${rigor_notes}"
    WORKING_DIRECTORY "${rigor_folder}" ${rigor_limit}
    RESULT_VARIABLE rigor_result OUTPUT_QUIET ERROR_QUIET)
  if(rigor_result STREQUAL "0")
    set(rigor_listed ON)
    include("${rigor_listing}")
  else()
    file(REMOVE "${rigor_listing}") # the test below fails, and says why
  endif()
endif()

add_test("${rigor_name} (checked)" "${rigor_program}" cases "--name=${rigor_name}"
  --into "${rigor_results}" ${rigor_options} -- "${rigor_notes}")
set_tests_properties("${rigor_name} (checked)" PROPERTIES
  FIXTURES_SETUP "${rigor_fixture}" LABELS "${rigor_labels}" WORKING_DIRECTORY "${rigor_folder}")
if(rigor_timeout)
  set_tests_properties("${rigor_name} (checked)" PROPERTIES TIMEOUT ${rigor_timeout})
endif()
