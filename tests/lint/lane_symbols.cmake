# SPDX-License-Identifier: GPL-3.0-or-later
# What the lane kernels may define: nothing that the linker could also take for code compiled for other instruction
# sets. Every symbol of an object file must stand in the namespace of its set.
#
#   cmake -D NM=nm -D SET=x86_64_v4 -D OBJECTS=a.o+b.o -P tests/lint/lane_symbols.cmake
cmake_minimum_required(VERSION 3.25)

string(REPLACE ".o+" ".o;" OBJECTS "${OBJECTS}")
execute_process(COMMAND ${NM} --defined-only --extern-only --demangle ${OBJECTS}
  OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[][;]" " " text "${text}")
string(REGEX MATCHALL "[^\n]+" lines "${text}")
set(symbols 0)
set(breaches 0)
foreach(line IN LISTS lines)
  if(line MATCHES "^[0-9a-f]+ [A-Za-z] (.*)$")
    math(EXPR symbols "${symbols} + 1")
    set(symbol "${CMAKE_MATCH_1}")
    if(NOT symbol MATCHES "rigor::${SET}::" AND NOT symbol MATCHES "^(DW\\.ref\\.|__odr_asan)")
      message(NOTICE "${OBJECTS}: `${symbol}` is not in rigor::${SET}")
      math(EXPR breaches "${breaches} + 1")
    endif()
  endif()
endforeach()
if(symbols EQUAL 0)
  message(FATAL_ERROR "${OBJECTS} defines nothing")
endif()
if(breaches GREATER 0)
  message(FATAL_ERROR "${breaches} symbols that other instruction sets could get")
endif()
