# SPDX-License-Identifier: GPL-3.0-or-later
# lintian says nothing about the packages that debian.cmake made.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
find_program(LINTIAN lintian)
file(GLOB packages ${WORK}/packages/*.deb)
if(NOT LINTIAN OR NOT packages)
  message(NOTICE "skipped: there is no lintian here, or there are no packages")
  return()
endif()
run(0 ${LINTIAN} --fail-on error,warning ${packages})
