# SPDX-License-Identifier: GPL-3.0-or-later
# Each installed header compiles alone, with all warnings, from C++17 on.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
find_program(CXX NAMES c++ g++ REQUIRED)
file(GLOB headers ${PREFIX}/include/rigor/*.h)
list(LENGTH headers count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "headers: ${headers}")
endif()
foreach(header IN LISTS headers)
  get_filename_component(name ${header} NAME)
  file(WRITE ${WORK}/header.cpp "#include <rigor/${name}>\nint main() {}\n")
  foreach(standard IN ITEMS 17 20 23)
    run(0 ${CXX} -std=c++${standard} -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
      -I${PREFIX}/include ${WORK}/header.cpp)
  endforeach()
endforeach()
