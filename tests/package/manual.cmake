# SPDX-License-Identifier: GPL-3.0-or-later
# The manual page renders without a warning, and has what --help has.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
find_program(MAN man)
if(NOT MAN)
  message(NOTICE "skipped: there is no man here")
  return()
endif()
set(page ${PREFIX}/share/man/man1/rigor.1.gz)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 MANWIDTH=80 ${MAN} --warnings -P cat -l ${page}
  OUTPUT_VARIABLE output ERROR_VARIABLE warnings RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT warnings STREQUAL "")
  message(FATAL_ERROR "man ended with ${result} and says: ${warnings}")
endif()
foreach(text IN ITEMS "rigor - checks the equations" "EXIT STATUS" "rigor check [OPTIONS] [FILE...]" "--sidecar FILE"
    "rigor eval notes/rigid-bodies.md --at '(6)'")
  expect("${text}")
endforeach()
