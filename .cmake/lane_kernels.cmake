# SPDX-License-Identifier: GPL-3.0-or-later
# What runs in lanes, compiled once for each instruction set that compiler and processor know.
include(CheckCXXSourceCompiles)

# The instruction sets, and how many doubles each has at once.
set(RIGOR_INSTRUCTION_SETS baseline)
set(RIGOR_LANES_baseline 2)
set(RIGOR_LANES_x86_64_v3 4)
set(RIGOR_LANES_x86_64_v4 8)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(CMAKE_REQUIRED_FLAGS -march=x86-64-v4)
  check_cxx_source_compiles("int main() { return __builtin_cpu_supports(\"x86-64-v4\"); }" RIGOR_X86_64_LEVELS)
  unset(CMAKE_REQUIRED_FLAGS)
  if(RIGOR_X86_64_LEVELS)
    list(APPEND RIGOR_INSTRUCTION_SETS x86_64_v3 x86_64_v4)
  endif()
endif()

# Adds the kernels of these sources to `target`, with its options.
function(rigor_add_lane_kernels target)
  foreach(set IN LISTS RIGOR_INSTRUCTION_SETS)
    set(kernels ${target}_${set})
    add_library(${kernels} OBJECT ${ARGN})
    target_include_directories(${kernels} PRIVATE src)
    target_compile_options(${kernels} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_OPTIONS>)
    target_compile_definitions(${kernels} PRIVATE RIGOR_INSTRUCTION_SET=${set} RIGOR_LANES=${RIGOR_LANES_${set}})
    if(NOT set STREQUAL "baseline")
      string(REPLACE _ - march ${set})
      target_compile_options(${kernels} PRIVATE -march=${march})
      target_compile_definitions(${target} PRIVATE RIGOR_X86_64_LEVELS)
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
