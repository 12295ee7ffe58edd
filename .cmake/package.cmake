# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages, by `cmake --build build/release --target package`: the program; the library; its headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rigor)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "Rigor")
set(CPACK_PACKAGE_CONTACT "Rigor authors <rigor@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL rigor library development)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CPACK_PACKAGE_CONTACT}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# rigor_package(COMPONENT NAME SECTION SUMMARY [DEPENDS]): one package, with its copyright, changelog and overrides.
function(rigor_package component name section summary depends)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${ARGN}" PARENT_SCOPE)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${name})
  install(FILES .cmake/package/copyright DESTINATION ${folder} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/manual/changelog.Debian.gz DESTINATION ${folder} COMPONENT ${component})
  configure_file(.cmake/package/${component}.overrides manual/overrides/${name} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/manual/overrides/${name}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
endfunction()

set(what "For every step of every displayed equation in LaTeX or Markdown it says whether
it is proved, refuted with a sample, or open, and what each written form costs
and how wrong it is in floating point.")
rigor_package(rigor rigor science "checker of the equations in physics notes" ""
  "${what}")
rigor_package(library librigor${abi} libs "checker of the equations in physics notes - library" ""
  "${what}\n.\nThis package has the library for programs in C++.")
rigor_package(development librigor-dev libdevel "checker of the equations in physics notes - headers"
  "librigor${abi} (= ${PROJECT_VERSION}-1), rigor (= ${PROJECT_VERSION}-1)"
  "${what}\n.\nThis package has headers for programs in C++, and matchers for Catch2.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/.cmake/package/triggers)

configure_file(.cmake/package/changelog.in manual/changelog.Debian @ONLY)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/manual/changelog.Debian.gz
  COMMAND ${GZIP} -9nkf ${PROJECT_BINARY_DIR}/manual/changelog.Debian
  DEPENDS ${PROJECT_BINARY_DIR}/manual/changelog.Debian
  VERBATIM)
add_custom_target(changelog ALL DEPENDS ${PROJECT_BINARY_DIR}/manual/changelog.Debian.gz)
include(CPack)
