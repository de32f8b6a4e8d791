# What `cpack -G DEB` makes of the installed components: dumbbell, libdumbbell0.1, libdumbbell-dev, and python3-dumbbell if
# the module is built.
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME dumbbell)
set(CPACK_PACKAGE_CONTACT "The dumbbell authors <dumbbell@example.org>" CACHE STRING "maintainer of the packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs libraries development)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY =)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(exactly "(= ${PROJECT_VERSION})")
set(interface libdumbbell${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(about "Two point masses on a massless rod fly in a plane, without gravity, towards
a flat floor and bounce elastically. dumbbell finds the greatest number of
times that they can hit it, for a mass ratio or for a whole range, by
interval arithmetic, and writes a certificate that an independent verifier
re-checks.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME dumbbell)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION ${about})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME ${interface})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
file(WRITE ${PROJECT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_LIBRARIES_DESCRIPTION "${about}

This package has the libraries of the prover and of the verifier.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdumbbell-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "dumbbell ${exactly}, ${interface} ${exactly}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${about}

This package has the C++ headers, and the CMake package with the programs
and the libraries.")
if(TARGET dumbbell_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-dumbbell)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), ${interface} ${exactly}")
  # Compiled when it is installed, as Debian does it; nothing of that stays when it goes.
  foreach(script postinst:py3compile prerm:py3clean)
    string(REGEX MATCH "(.*):(.*)" script ${script})
    file(WRITE ${PROJECT_BINARY_DIR}/${CMAKE_MATCH_1} "#!/bin/sh\nset -e\n"
      "if command -v ${CMAKE_MATCH_2} > /dev/null 2>&1; then ${CMAKE_MATCH_2} -p python3-dumbbell; fi\n")
    list(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/${CMAKE_MATCH_1})
  endforeach()
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src/wings/api)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${about}

This package has the module for Python.")
endif()

# Where the script below puts what Debian wants in each package.
set(CPACK_DUMBBELL_PACKAGES programs dumbbell libraries ${interface} development libdumbbell-dev)
if(TARGET dumbbell_python)
  list(APPEND CPACK_DUMBBELL_PACKAGES python python3-dumbbell)
endif()
set(CPACK_DUMBBELL_FOLDER ${PROJECT_SOURCE_DIR})
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian-files.cmake)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
include(CPack)
