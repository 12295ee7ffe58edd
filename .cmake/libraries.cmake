# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries of others. `.ci/setup` installs them on Debian; the versions are the oldest that were tried.
find_package(fmt 9 REQUIRED)
find_package(tl-expected 1.0 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED) # headers only

# utfcpp is headers only, and its CMake target is named differently from version to version.
find_path(UTF8CPP_INCLUDE_DIR utf8/checked.h PATH_SUFFIXES utf8cpp REQUIRED)
mark_as_advanced(UTF8CPP_INCLUDE_DIR)
add_library(rigor::utf8cpp INTERFACE IMPORTED)
target_include_directories(rigor::utf8cpp INTERFACE ${UTF8CPP_INCLUDE_DIR})

find_package(PkgConfig REQUIRED)
pkg_check_modules(GINAC REQUIRED IMPORTED_TARGET ginac>=1.8 cln>=1.3)
add_library(rigor::ginac ALIAS PkgConfig::GINAC)

# The blocks of Markdown. What pkg-config says links the extensions, too, which are not used.
find_path(CMARK_GFM_INCLUDE_DIR cmark-gfm.h REQUIRED)
find_library(CMARK_GFM_LIBRARY cmark-gfm REQUIRED)
mark_as_advanced(CMARK_GFM_INCLUDE_DIR CMARK_GFM_LIBRARY)
add_library(rigor::cmark-gfm INTERFACE IMPORTED)
target_include_directories(rigor::cmark-gfm INTERFACE ${CMARK_GFM_INCLUDE_DIR})
target_link_libraries(rigor::cmark-gfm INTERFACE ${CMARK_GFM_LIBRARY})

# Double-double arithmetic. The library proper has the functions beyond + - * / and the roots.
find_path(QD_INCLUDE_DIR qd/dd_real.h REQUIRED)
find_library(QD_LIBRARY qd REQUIRED)
mark_as_advanced(QD_INCLUDE_DIR QD_LIBRARY)
add_library(rigor::qd INTERFACE IMPORTED)
target_include_directories(rigor::qd INTERFACE ${QD_INCLUDE_DIR})
target_link_libraries(rigor::qd INTERFACE ${QD_LIBRARY})

find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)
mark_as_advanced(TOMLPLUSPLUS_INCLUDE_DIR)
add_library(rigor::tomlplusplus INTERFACE IMPORTED)
target_include_directories(rigor::tomlplusplus INTERFACE ${TOMLPLUSPLUS_INCLUDE_DIR})
