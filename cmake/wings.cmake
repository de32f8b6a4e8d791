# What is built besides the mission, which is the maximum, its certificates and their verifier: DUMBBELL_WINGS.
# `-DDUMBBELL_WINGS=` is the mission alone.
set(all_wings starts adiabatic law audit pictures page api second)
set(DUMBBELL_WINGS "${all_wings}" CACHE STRING "what is built besides the mission: ${all_wings}")
set(adiabatic_needs starts)
set(pictures_needs starts)
set(page_needs adiabatic pictures)
set(api_needs law pictures)

foreach(wing IN LISTS DUMBBELL_WINGS)
  if(NOT wing IN_LIST all_wings)
    list(JOIN all_wings ", " all)
    message(FATAL_ERROR "DUMBBELL_WINGS: there is no wing ${wing}, but ${all}")
  endif()
  foreach(needed IN LISTS ${wing}_needs)
    if(NOT needed IN_LIST DUMBBELL_WINGS)
      message(FATAL_ERROR "DUMBBELL_WINGS: the wing ${wing} needs the wing ${needed}")
    endif()
  endforeach()
endforeach()
set(has_all_wings TRUE)  # many tests are of such a build alone
foreach(wing IN LISTS all_wings)
  if(NOT wing IN_LIST DUMBBELL_WINGS)
    set(has_all_wings FALSE)
  endif()
endforeach()
if(DUMBBELL_PYTHON_MODULE AND NOT api IN_LIST DUMBBELL_WINGS)
  message(FATAL_ERROR "DUMBBELL_WINGS: the module for Python needs the wing api")
endif()

# Their headers are found by what links this, so by no target of the mission.
add_library(dumbbell_wings INTERFACE)
target_include_directories(dumbbell_wings INTERFACE ${PROJECT_SOURCE_DIR}/src/wings)
