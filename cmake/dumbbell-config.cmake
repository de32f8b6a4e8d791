# find_package(dumbbell) gives the installed programs as dumbbell::dumbbell-verify and dumbbell::dumbbell, the libraries
# as dumbbell::verify and dumbbell::prove, and the function dumbbell_add_proof_check(). The second of each is not there
# if only the verifier was built. Components are the libraries: find_package(dumbbell REQUIRED COMPONENTS prove).
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/dumbbell-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/dumbbell-proof-check.cmake)

foreach(component IN LISTS dumbbell_FIND_COMPONENTS)
  if(component MATCHES "^(prove|verify)$" AND TARGET dumbbell::${component})
    set(dumbbell_${component}_FOUND TRUE)
  elseif(dumbbell_FIND_REQUIRED_${component})
    set(dumbbell_FOUND FALSE)
    set(dumbbell_NOT_FOUND_MESSAGE "this dumbbell has no component ${component}: there are prove and verify")
  endif()
endforeach()
