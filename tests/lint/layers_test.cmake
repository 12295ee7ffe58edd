# SPDX-License-Identifier: GPL-3.0-or-later
# Shows that layers.cmake fails: breaks one rule at a time in a small good tree and looks for the message.
#
#   cmake -D TREE=<folder to write> -P tests/lint/layers_test.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../.cmake/floors.cmake)

set(spdx "// SPDX-License-Identifier: GPL-3.0-or-later\n")
set(failures 0)

# Where a floor's files may stand: `${in_<floor>}`, its lowest room.
foreach(floor IN LISTS RIGOR_FLOORS)
  set(in_${floor} src/${floor})
  if(RIGOR_${floor}_ROOMS)
    list(GET RIGOR_${floor}_ROOMS 0 room)
    string(APPEND in_${floor} /${room})
  endif()
endforeach()

function(make_good_tree)
  file(REMOVE_RECURSE ${TREE})
  foreach(floor IN LISTS RIGOR_FLOORS)
    file(WRITE ${TREE}/src/${floor}/README.md "${floor}\n")
    file(WRITE ${TREE}/${in_${floor}}/a.h "${spdx}#include <vector>\n")
    foreach(room IN LISTS RIGOR_${floor}_ROOMS)
      file(WRITE ${TREE}/src/${floor}/${room}/README.md "${room}\n")
    endforeach()
  endforeach()
  file(WRITE ${TREE}/${in_algebra}/b.cpp
    "${spdx}#include <ginac/ginac.h>\n\n#include \"base/a.h\"\n#include \"algebra/a.h\"\n")
  file(WRITE ${TREE}/src/app/main.cpp "${spdx}#include \"version.h\"\n#include \"latex/a.h\"\n")
  file(WRITE ${TREE}/tests/unit/base/a_test.cpp "${spdx}#include \"app/a.h\"\n")
  file(WRITE ${TREE}/src/report/latex/a.sty "% SPDX-License-Identifier: GPL-3.0-or-later\n")
endfunction()

function(run_lint)
  execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${TREE} -P ${CMAKE_CURRENT_LIST_DIR}/layers.cmake
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE exit_code)
  set(output "${output}" PARENT_SCOPE)
  set(exit_code "${exit_code}" PARENT_SCOPE)
endfunction()

# Writes `text` to `file` in a good tree and expects `message` alone of the lint. No text removes the file.
macro(expect_breach file text message)
  make_good_tree()
  if("${text}" STREQUAL "")
    file(REMOVE_RECURSE ${TREE}/${file})
  else()
    file(WRITE ${TREE}/${file} "${text}")
  endif()
  run_lint()
  string(FIND "${output}" "${message}\n" found)
  string(FIND "${output}" "broken in 1 places" alone)
  if(exit_code EQUAL 0 OR found EQUAL -1 OR alone EQUAL -1)
    message(NOTICE "expected: ${message}\nthe lint ended with ${exit_code} and said: ${output}")
    math(EXPR failures "${failures} + 1")
  endif()
endmacro()

make_good_tree()
run_lint()
if(NOT exit_code EQUAL 0 OR NOT output STREQUAL "")
  message(FATAL_ERROR "a good tree was refused: ${output}")
endif()

expect_breach(${in_latex}/b.h "${spdx}\n#include \"expr/a.h\"\n"
  "${in_latex}/b.h:3: `latex` includes `expr/a.h`, but stands on: source base")
expect_breach(src/base/b.h "${spdx}#  include \"source/a.h\" // [;]\n"
  "src/base/b.h:2: `base` includes `source/a.h`, but stands on: ")
expect_breach(src/report/latex/b.sty "% words\n"
  "src/report/latex/b.sty:1: the first line is not `% SPDX-License-Identifier: GPL-3.0-or-later`")
expect_breach(${in_check}/b.h "${spdx}namespace rigor {\nstruct Use {\n};\nclass Use : public Other {\n};\n}\n"
  "${in_check}/b.h:5: `rigor::Use` is the name of another class, in ${in_check}/b.h:3")
expect_breach(${in_check}/b.cpp "${spdx}// a;b;c [ \\\n\n#include <ginac/ginac.h>\n"
  "${in_check}/b.cpp:4: `check` includes `ginac/ginac.h`, which only `algebra` may")
expect_breach(${in_expr}/b.cpp "${spdx}#include \"cln/cln.h\"\n"
  "${in_expr}/b.cpp:2: `expr` includes `cln/cln.h`, which only `algebra` may")
expect_breach(${in_check}/b.cpp "${spdx}#include <Eigen/Dense>\n"
  "${in_check}/b.cpp:2: `check` includes `Eigen/Dense`, which only `algebra` may")
expect_breach(${in_check}/b.cpp "${spdx}#include <nlohmann/json.hpp>\n"
  "${in_check}/b.cpp:2: `check` includes `nlohmann/json.hpp`, which only `report` and `app` may")
expect_breach(src/base/b.cpp "${spdx}#include \"version.h\"\n"
  "src/base/b.cpp:2: `base` includes `version.h`, which only `report` and `app` may")
expect_breach(${in_app}/b.cpp "${spdx}#include <base/a.h>\n"
  "${in_app}/b.cpp:2: `<base/a.h>` is ours and is written \"base/a.h\"")
expect_breach(src/base/b.cpp "${spdx}#include \"a.h\"\n"
  "src/base/b.cpp:2: `a.h` does not begin with a floor, as in \"base/span.h\"")
expect_breach(src/base/b.cpp "int no_licence;\n"
  "src/base/b.cpp:1: the first line is not `// SPDX-License-Identifier: GPL-3.0-or-later`")
expect_breach(tests/unit/b_test.cpp "\n${spdx}"
  "tests/unit/b_test.cpp:1: the first line is not `// SPDX-License-Identifier: GPL-3.0-or-later`")
string(REPEAT "int;\n" 699 most)
string(REPEAT "\n" 700 more)
expect_breach(src/base/b.cpp "${spdx}${more}" "src/base/b.cpp:701: 701 lines, at most 700")
string(REPEAT "line\n" 26 long_readme)
expect_breach(src/base/README.md "${long_readme}" "src/base/README.md:26: 26 lines, at most 25")
expect_breach(src/base/README.md "" "src/base/README.md:1: missing: every floor says what it is")
expect_breach(src/base/b.cc "${spdx}" "src/base/b.cc:1: neither .h nor .cpp")
string(REPEAT "line\n" 11 long_readme)
expect_breach(src/check/walk/README.md "${long_readme}" "src/check/walk/README.md:11: 11 lines, at most 10")
expect_breach(src/check/walk/README.md "" "src/check/walk/README.md:1: missing: every room says what it is")
list(JOIN RIGOR_check_ROOMS " " rooms)
expect_breach(src/check/b.h "${spdx}" "src/check/b.h:1: stands in no room of `check`, which are: ${rooms}")
expect_breach(src/check/attic/b.h "${spdx}" "src/check/attic/b.h:1: stands in no room of `check`, which are: ${rooms}")
expect_breach(src/base/b.cpp "${spdx}#include \"base/a.h\"\n\nstd::vector<std::string> names;\n"
  "src/base/b.cpp:1: uses `std::string` without an include of `<string>`")
expect_breach(src/check/doubt/b.h "${spdx}#include \"check/walk/a.h\"\n"
  "src/check/doubt/b.h:2: the room `doubt` includes what stands above it, in `walk`")
expect_breach(src/attic/a.h "${spdx}" "src/attic:1: not a floor of .cmake/floors.cmake")
expect_breach(src/app "" "src/app:1: missing, but a floor of .cmake/floors.cmake")

# Too many files of a floor without rooms, and of a room.
make_good_tree()
foreach(k RANGE 1 20)
  file(WRITE ${TREE}/src/base/file${k}.h "${spdx}")
endforeach()
foreach(k RANGE 1 24)
  file(WRITE ${TREE}/${in_check}/file${k}.h "${spdx}")
endforeach()
run_lint()
foreach(message IN ITEMS "src/base:1: 21 files without rooms, at most 20" "${in_check}:1: 25 files in a room, at most 24")
  string(FIND "${output}" "${message}\n" found)
  if(found EQUAL -1)
    message(NOTICE "expected: ${message}\nthe lint said: ${output}")
    math(EXPR failures "${failures} + 1")
  endif()
endforeach()

# The last good sizes.
make_good_tree()
string(REPEAT "line\n" 25 readme)
file(WRITE ${TREE}/src/base/README.md "${readme}")
file(WRITE ${TREE}/src/base/b.cpp "${spdx}${most}")
run_lint()
if(NOT exit_code EQUAL 0)
  message(NOTICE "700 lines and a README of 25 were refused: ${output}")
  math(EXPR failures "${failures} + 1")
endif()

file(REMOVE_RECURSE ${TREE})
if(failures GREATER 0)
  message(FATAL_ERROR "${failures} rules are not kept by the lint")
endif()
