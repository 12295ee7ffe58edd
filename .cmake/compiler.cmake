# SPDX-License-Identifier: GPL-3.0-or-later
# How everything is compiled. `cmake --compile-no-warning-as-error` lets an unknown compiler through.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The floors go into a program and into a shared library, which shows nothing but its own interface. The
# sanitizers compare types by address, and would take a hidden one for another than GiNaC's own.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT RIGOR_SANITIZE)
  set(CMAKE_CXX_VISIBILITY_PRESET hidden)
  set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
endif()

if(NOT DEFINED CMAKE_COMPILE_WARNING_AS_ERROR)
  set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wconversion)
if(RIGOR_FEW_UNITS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-Wshadow=local) # what is local to one file is seen in others of its unit
else()
  add_compile_options(-Wshadow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # Fires inside std::string at `"literal" + string`: GCC bug 105651, fixed in 13.
  add_compile_options(-Wno-restrict)
endif()

# No path of the build machine in the program, its assertions or its debug information.
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)

# What every program links besides its code.
add_library(rigor_program INTERFACE)
if(RIGOR_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-maybe-uninitialized) # not reliable in instrumented code, as GCC's manual says
  endif()
  add_library(rigor_sanitizers OBJECT ${CMAKE_CURRENT_LIST_DIR}/sanitizers.cpp)
  target_link_libraries(rigor_program INTERFACE rigor_sanitizers $<TARGET_OBJECTS:rigor_sanitizers>)
endif()

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
