# SPDX-License-Identifier: GPL-3.0-or-later
# A project without a language: names with odd characters, the options, files that come and go.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(project ${WORK}/notes-only)
set(build ${WORK}/notes-only-build)
set(ctest ${CMAKE_CTEST_COMMAND} --test-dir ${build} --output-on-failure)
file(REMOVE_RECURSE ${project} ${build})

set(head "cmake_minimum_required(VERSION 3.16)
project(lectures LANGUAGES NONE)
enable_testing()
find_package(rigor REQUIRED COMPONENTS notes)
")
file(WRITE ${project}/CMakeLists.txt "${head}
rigor_add_notes(odd \"odd names.md\" [[a;b.md]] same.md same.tex)
rigor_add_notes(open open.md SKIP_OPEN TIMEOUT 60 LABELS lecture draft)
rigor_add_notes(strict same.md STRICT WORKING_DIRECTORY \${CMAKE_CURRENT_SOURCE_DIR}/..)
rigor_add_notes(aside aside.md SIDECAR physics.rigor)
rigor_add_notes(dash -dash.md WORKING_DIRECTORY \${CMAKE_CURRENT_SOURCE_DIR})
")
set(true_step "\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}")
file(WRITE "${project}/odd names.md" "
$$${true_step} \\tag{a;b}$$
$$${true_step} \\tag{[x}$$
$$${true_step} \\tag{\\alpha]]}$$
$$${true_step} \\tag{\$x \"q\" #}$$
$$${true_step} \\tag{6}$$
$$${true_step} \\tag{6}$$
$$${true_step}$$
")
file(WRITE "${project}/a;b.md" "$$${true_step}$$\n")
file(WRITE "${project}/-dash.md" "$$${true_step}$$\n")
file(WRITE "${project}/same.md" "$$${true_step}$$\n")
file(WRITE "${project}/same.tex" "$$${true_step}$$\n")
file(WRITE "${project}/open.md" "$$\\oint f(s)\\,ds = 0$$\n")
file(WRITE "${project}/aside.md" "$$m\\dot{\\mathbf{v}}\\cdot\\mathbf{v} = 0$$\n")
file(WRITE "${project}/physics.rigor" "constant m\ngiven \\mathbf{v}\\cdot\\dot{\\mathbf{v}} = 0\n")

run(0 ${CMAKE_COMMAND} -S ${project} -B ${build} -G Ninja -D CMAKE_PREFIX_PATH=${PREFIX})
run(0 ${ctest})
foreach(name IN ITEMS "odd names (a;b) step 1" "odd names ([x) step 1" "odd names (\\alpha]]) step 1"
    "odd names (6) step 2" "odd names line 8" "a;b line 1" "same line 1" "same.tex line 1" "notes-only/same line 1"
    "-dash line 1")
  expect(": ${name} ..")
endforeach()
expect("open line 1 .")
expect("***Skipped")
run(0 ${ctest} -L lecture)
expect("lecture")

# A step by its name alone brings the check of its notes with it.
run(0 ${ctest} -R "odd names .6. step 2")
expect("out of 2")

# A sidecar that appears, an unused directive, notes that disappear.
file(WRITE ${project}/same.rigor "vector \\mathbf{Q}\n")
run(8 ${ctest})
expect("[unused-directive]")
expect("same.rigor:1:")
expect_failed("same (whole file)" "same.tex (whole file)" "notes-only/same (whole file)")
file(REMOVE ${project}/same.rigor ${project}/same.tex)
run(8 ${ctest})
expect_failed("same.tex (checked)")
expect("same.tex:1:1: error: no such file")
file(WRITE ${project}/same.tex "$$${true_step}$$\n\\input{part}\n$$${true_step} \\tag{2}$$\n")
run(8 ${ctest})
expect_failed("same.tex (whole file)")
expect("[missing-input]")
expect(": same.tex (2) step 1 ..")
file(WRITE ${project}/part.tex "$$${true_step} \\tag{1}$$\n")
run(0 ${ctest})
expect(": same.tex: part.tex (1) step 1 ..")
run(0 ${CMAKE_COMMAND} --build ${build} --target aside)
expect("proved")
