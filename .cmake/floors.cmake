# SPDX-License-Identifier: GPL-3.0-or-later
# The floors of src/ from the ground up, written once: CMakeLists.txt makes the link graph of it and
# tests/lint/layers.cmake checks every #include against it. A floor may include what it stands on, and theirs.
#
#   RIGOR_FLOORS               all floors, lowest first
#   RIGOR_<floor>_ON           the floors directly beneath it
#   RIGOR_<floor>_BELOW        all floors beneath it
#   RIGOR_<floor>_ROOMS        its folders, lowest first; a file includes nothing of a room above its own
#   RIGOR_FILES_WITHOUT_ROOM   what stands above all rooms of its floor
#   RIGOR_<floor>_LIBRARIES    what is seen of other projects by it and by the floors above it
#   RIGOR_<floor>_PRIVATE      what only its own sources see
#   RIGOR_ONLY_<folder>        the floors that may include <folder/...> of another project
set(RIGOR_FLOORS "")

macro(rigor_floor name)
  cmake_parse_arguments(RIGOR_${name} "" "" "ON;ROOMS;LIBRARIES;PRIVATE" ${ARGN})
  set(RIGOR_${name}_BELOW "")
  foreach(_floor IN LISTS RIGOR_${name}_ON)
    if(NOT _floor IN_LIST RIGOR_FLOORS)
      message(FATAL_ERROR "floor `${name}` stands on `${_floor}`, which is not below it")
    endif()
    list(APPEND RIGOR_${name}_BELOW ${_floor} ${RIGOR_${_floor}_BELOW})
  endforeach()
  list(REMOVE_DUPLICATES RIGOR_${name}_BELOW)
  list(APPEND RIGOR_FLOORS ${name})
endmacro()

rigor_floor(base LIBRARIES fmt::fmt tl::expected rigor::utf8cpp)
rigor_floor(source ON base)
rigor_floor(latex ON source PRIVATE rigor::cmark-gfm
  ROOMS token unit macro split parse reading layout text markdown document)
rigor_floor(expr ON source
  ROOMS tree calculus print statement)
rigor_floor(elaborate ON latex expr
  ROOMS evidence name reading symbol notation)
rigor_floor(algebra ON expr PRIVATE rigor::ginac Eigen3::Eigen
  ROOMS engine packed words parts point evaluator ring form generic sample rough decide)
rigor_floor(numeric ON expr PRIVATE rigor::qd Boost::boost
  ROOMS lane kernels exact program run body mesh family measure advice)
rigor_floor(check ON elaborate algebra
  ROOMS step word directive prose event ledger average question meaning verdict scope doubt constant law repair place row walk dimension form shown
    lint review entry)
rigor_floor(derive ON algebra
  ROOMS polynomial notation chain answer)
rigor_floor(scene ON elaborate numeric PRIVATE rigor::tomlplusplus Boost::boost
  ROOMS motion file quantity)
rigor_floor(report ON check derive scene PRIVATE nlohmann_json::nlohmann_json
  ROOMS picture wording suggest text data read page)
rigor_floor(api ON report)
rigor_floor(app ON report PRIVATE nlohmann_json::nlohmann_json CLI11::CLI11
  ROOMS grammar host hole command)

set(RIGOR_FILES_WITHOUT_ROOM src/app/main.cpp)

set(RIGOR_ONLY_cmark-gfm.h latex)
set(RIGOR_ONLY_ginac algebra)
set(RIGOR_ONLY_cln algebra)
set(RIGOR_ONLY_Eigen algebra)
set(RIGOR_ONLY_qd numeric)
set(RIGOR_ONLY_boost numeric scene)
set(RIGOR_ONLY_toml++ scene)
set(RIGOR_ONLY_nlohmann report app)
set(RIGOR_ONLY_CLI app)
set(RIGOR_ONLY_version.h report app)
