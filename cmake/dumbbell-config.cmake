# find_package(dumbbell) gives the installed programs as dumbbell::dumbbell-verify and, unless only the verifier
# was built, dumbbell::dumbbell; and the function dumbbell_add_proof_check().
cmake_minimum_required(VERSION 3.25)

foreach(component IN LISTS dumbbell_FIND_COMPONENTS)
  if(dumbbell_FIND_REQUIRED_${component})
    set(dumbbell_FOUND FALSE)
    set(dumbbell_NOT_FOUND_MESSAGE "dumbbell has no components, so there is no ${component}")
    return()
  endif()
endforeach()

include(${CMAKE_CURRENT_LIST_DIR}/dumbbell-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/dumbbell-proof-check.cmake)
