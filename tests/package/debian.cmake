# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages: what is unpacked from them runs, and they say what they need.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
find_program(DPKG_DEB dpkg-deb)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
find_program(FILE file)
if(NOT DPKG_DEB OR NOT DPKG_SHLIBDEPS OR NOT FILE)
  message(NOTICE "skipped: dpkg-deb, dpkg-shlibdeps and file are needed to make packages")
  return()
endif()

set(root ${WORK}/unpacked)
file(REMOVE_RECURSE ${WORK}/packages ${root})
run(0 ${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -B ${WORK}/packages
  -D CPACK_OUTPUT_FILE_PREFIX=${WORK}/packages)
file(GLOB packages ${WORK}/packages/*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 3)
  message(FATAL_ERROR "packages: ${packages}")
endif()
foreach(package IN LISTS packages)
  run(0 ${DPKG_DEB} -x ${package} ${root})
  run(0 ${DPKG_DEB} -f ${package} Package Depends Maintainer Section)
  expect("Maintainer: Rigor authors <rigor@example.org>")
  expect("Depends: lib")
endforeach()

foreach(file IN ITEMS bin/rigor share/man/man1/rigor.1.gz share/bash-completion/completions/rigor
    share/doc/rigor/copyright share/doc/librigor-dev/changelog.Debian.gz lib/librigor.so include/rigor/catch.h
    lib/cmake/rigor/rigorConfig.cmake lib/cmake/rigor/rigorApiTargets.cmake)
  if(NOT EXISTS ${root}/usr/${file})
    message(FATAL_ERROR "no package has ${file}")
  endif()
endforeach()
run(0 ${root}/usr/bin/rigor --version)
run(0 ${root}/usr/bin/rigor check ${SOURCE}/tests/example/notes/vectors.md)
expect("2 steps: 2 proved")
