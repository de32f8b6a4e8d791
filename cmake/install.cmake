# What `cmake --install` installs. The package lies in share/, where find_package() looks whatever languages the
# other project has.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_DATADIR}/cmake/dumbbell)

set(programs dumbbell-verify)
if(NOT DUMBBELL_VERIFIER_ONLY)
  list(APPEND programs dumbbell)
endif()
install(TARGETS ${programs} EXPORT dumbbell-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT dumbbell-targets NAMESPACE dumbbell:: DESTINATION ${package})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/dumbbell-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  ${PROJECT_BINARY_DIR}/dumbbell-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dumbbell-config.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dumbbell-proof-check.cmake
  DESTINATION ${package})

install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs proofs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES src/verify/dumbbell-verify.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
# Made by the target `pages`, one of ALL; a build of the programs alone has none.
if(NOT DUMBBELL_VERIFIER_ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/share/dumbbell.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
  foreach(command dumbbell dumbbell-verify)  # completions are found by the command's name
    install(FILES ${PROJECT_BINARY_DIR}/share/dumbbell.bash
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${command} OPTIONAL)
  endforeach()
endif()
install(DIRECTORY certificates DESTINATION ${CMAKE_INSTALL_DATADIR}/dumbbell)
