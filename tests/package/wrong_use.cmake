# SPDX-License-Identifier: GPL-3.0-or-later
# rigor_add_notes refuses what cannot be meant, when the project is configured.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(project ${WORK}/wrong)

function(expect_refusal call message)
  file(REMOVE_RECURSE ${project})
  file(WRITE ${project}/a.md "$$1 = 1$$\n")
  file(WRITE ${project}/b.md "$$1 = 1$$\n")
  file(WRITE ${project}/s.rigor "\n")
  file(WRITE ${project}/CMakeLists.txt "cmake_minimum_required(VERSION 3.16)
project(wrong LANGUAGES NONE)
find_package(rigor REQUIRED)
${call}
")
  run(1 ${CMAKE_COMMAND} -S ${project} -B ${project}/build -G Ninja -D CMAKE_PREFIX_PATH=${PREFIX})
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  expect("${message}")
endfunction()

expect_refusal("rigor_add_notes(n)" "rigor_add_notes(n): no notes are given")
expect_refusal("rigor_add_notes(n missing.md)" "missing.md is no file")
expect_refusal("rigor_add_notes(n .)" "wrong is no file")
expect_refusal("rigor_add_notes(n a.md b.md SIDECAR s.rigor)" "SIDECAR belongs to one file, and 2 are given")
expect_refusal("rigor_add_notes(n a.md SIDECAR t.rigor)" "t.rigor is no file")
expect_refusal("rigor_add_notes(n a.md SIDECAR)" "nothing stands behind SIDECAR")
expect_refusal("rigor_add_notes(n a.md TIMEOUT soon)" "TIMEOUT `soon` is no number of seconds")
expect_refusal("find_package(rigor REQUIRED COMPONENTS fortran)" "fortran")
expect_refusal("find_package(rigor 99 REQUIRED)" "99")
