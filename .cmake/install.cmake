# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` installs: program, manual page, completion and the CMake package; and the library with
# its headers. Nothing of it knows the folder where it is.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME rigor)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rigor)

# The page and the completion are made of the words that the program itself knows.
set(manual ${PROJECT_BINARY_DIR}/manual)
find_program(GZIP gzip REQUIRED)
mark_as_advanced(GZIP)
add_custom_command(OUTPUT ${manual}/rigor.1.gz ${manual}/rigor
  COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
  COMMAND rigor manual > ${manual}/rigor.1
  COMMAND ${GZIP} -9nf ${manual}/rigor.1
  COMMAND rigor completion > ${manual}/rigor
  DEPENDS rigor
  COMMENT "Writing the manual page and the completion"
  VERBATIM)
add_custom_target(manual ALL DEPENDS ${manual}/rigor.1.gz ${manual}/rigor)

install(TARGETS rigor EXPORT rigorTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${manual}/rigor.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual}/rigor DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES src/report/latex/rigor.sty src/report/latex/rigorverdicts.sty # where TeX Live looks beside what it has itself
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/texmf/tex/latex/rigor)

install(EXPORT rigorTargets NAMESPACE rigor:: DESTINATION ${package_folder})
configure_package_config_file(.cmake/package/rigorConfig.cmake.in generated/rigorConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(generated/rigorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/generated/rigorConfig.cmake ${PROJECT_BINARY_DIR}/generated/rigorConfigVersion.cmake
  .cmake/package/rigorNotes.cmake .cmake/package/rigorListSteps.cmake
  DESTINATION ${package_folder})

install(TARGETS rigor_library EXPORT rigorApiTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY src/api/rigor DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN *.h)
install(EXPORT rigorApiTargets NAMESPACE rigor:: DESTINATION ${package_folder} COMPONENT development)
