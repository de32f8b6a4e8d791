# GMP::gmp, MPFR::mpfr, Nettle::nettle and Arb::arb as imported targets (the verifier needs the first three): none
# of them has a CMake package, and Arb has no pkg-config file. Since version 3 FLINT has Arb, its headers in the folder flint:
# src/number/flint.hpp includes them.
function(dumbbell_import package target header library)
  find_path(${package}_INCLUDE_DIR NAMES ${header})
  find_library(${package}_LIBRARY NAMES ${library})
  mark_as_advanced(${package}_INCLUDE_DIR ${package}_LIBRARY)
  if(NOT ${package}_INCLUDE_DIR OR NOT ${package}_LIBRARY)
    message(FATAL_ERROR "${package} not found (${header}, lib${library}); "
      "on Debian: .ci/install build, or verify for the verifier alone")
  endif()
  add_library(${target} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES
    IMPORTED_LOCATION "${${package}_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${${package}_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${ARGN}")
  # Found again by what is linked; CMAKE_INSTALL_RPATH_USE_LINK_PATH leaves out what lies in the build folder (docs/install.md).
  cmake_path(GET ${package}_LIBRARY PARENT_PATH folder)
  if(NOT CMAKE_SYSROOT AND NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES AND NOT folder IN_LIST CMAKE_INSTALL_RPATH)
    set(CMAKE_INSTALL_RPATH ${CMAKE_INSTALL_RPATH} ${folder} PARENT_SCOPE)
  endif()
endfunction()

dumbbell_import(GMP GMP::gmp gmp.h gmp)
dumbbell_import(MPFR MPFR::mpfr mpfr.h mpfr GMP::gmp)
dumbbell_import(NETTLE Nettle::nettle nettle/sha2.h nettle)
if(NOT DUMBBELL_VERIFIER_ONLY)
  dumbbell_import(FLINT Arb::flint flint/flint.h flint MPFR::mpfr)
  dumbbell_import(ARB Arb::arb "acb_calc.h;flint/acb_calc.h" "flint-arb;arb;flint" Arb::flint)
endif()
