# What `cmake --install` installs, in components: programs (with the pages and the certificates), libraries, development
# (headers, and what find_package() and pkg-config find) and, if it is built, python (the module). The package lies in share/, where find_package() looks whatever
# languages the other project has.
# Debian's place for libraries also below other prefixes than /usr, for which alone GNUInstallDirs knows it: the packages
# are made from a build with any prefix.
if(NOT DEFINED CMAKE_INSTALL_LIBDIR AND CMAKE_LIBRARY_ARCHITECTURE AND EXISTS /etc/debian_version)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "libraries, below the prefix")
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_DATADIR}/cmake/dumbbell)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)

set(programs dumbbell-verify)
set(libraries "")
foreach(library dumbbell_api_verify dumbbell_api_prove)
  if(TARGET ${library})
    list(APPEND libraries ${library})
  endif()
endforeach()
if(NOT DUMBBELL_VERIFIER_ONLY)
  list(APPEND programs dumbbell)
endif()
add_custom_target(installable DEPENDS ${programs} ${libraries})  # what has to be built before
if(TARGET pages)
  add_dependencies(installable pages)
endif()
install(TARGETS ${programs} EXPORT dumbbell-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(libraries)
  install(TARGETS ${libraries} EXPORT dumbbell-targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endif()
install(EXPORT dumbbell-targets NAMESPACE dumbbell:: DESTINATION ${package} COMPONENT development)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/dumbbell-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/dumbbell-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dumbbell-config.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dumbbell-proof-check.cmake
  DESTINATION ${package} COMPONENT development)

# pkg-config's files find the prefix from where they lie: it may be another one when they are installed.
file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" to_prefix "${to_prefix}")
foreach(library prove verify)
  if(TARGET dumbbell_api_${library})
    configure_file(cmake/dumbbell.pc.in dumbbell-${library}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/dumbbell-${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
      COMPONENT development)
  endif()
endforeach()

if(TARGET dumbbell_python)
  set(module lib/python${Python_VERSION_MAJOR}/dist-packages/dumbbell)  # where Debian's Python looks
  add_dependencies(installable dumbbell_python)
  install(TARGETS dumbbell_python LIBRARY DESTINATION ${module} COMPONENT python)
  # Its libraries are not beside it then.
  install(CODE "file(RPATH_REMOVE FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${module}/$<TARGET_FILE_NAME:dumbbell_python>\")"
    COMPONENT python)
  install(FILES src/wings/python/__init__.py src/wings/python/__init__.pyi src/wings/python/_given.py src/wings/python/py.typed DESTINATION ${module} COMPONENT python)
endif()

install(FILES LICENSE README.md CHANGELOG.md CITATION.bib CITATION.cff CONTRIBUTING.md SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs proofs DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Made by the targets `verifier_page` and `pages`, two of ALL; a build of the programs alone has none.
install(FILES ${PROJECT_BINARY_DIR}/share/dumbbell-verify.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
if(NOT DUMBBELL_VERIFIER_ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/share/dumbbell.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endif()
# The verifier for pages of `dumbbell report`, where `./run web` has made it.
install(FILES ${PROJECT_SOURCE_DIR}/build/web/verifier.wasm.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/dumbbell OPTIONAL)
# The pages name the certificates as in the source: below the pages' folder.
install(DIRECTORY certificates DESTINATION ${CMAKE_INSTALL_DATADIR}/dumbbell)
file(RELATIVE_PATH certificates ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_DATADIR}/dumbbell/certificates)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share)
file(CREATE_LINK ${certificates} ${PROJECT_BINARY_DIR}/share/certificates SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/share/certificates DESTINATION ${CMAKE_INSTALL_DOCDIR})
