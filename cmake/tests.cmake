# dumbbell_add_tests(NAME SOURCES file... LIBS target... [LABELS label...])
#
# A Catch2 program of which every TEST_CASE is one ctest test, called "NAME/test case". The label is
# `unit` unless told otherwise (`long`: takes minutes, `cli`: runs the programs, `proofs`: checks shipped certificates). An hour ends a test case that hangs, and none because the machine is busy.
find_package(Catch2 REQUIRED)
include(Catch)

# Catch's main(), of version 2 compiled here and once: Debian's Catch2::Catch2WithMain of it is compiled as C++11 and lacks
# what <string_view> needs.
add_library(dumbbell_catch_main STATIC ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
target_compile_features(dumbbell_catch_main PUBLIC cxx_std_20)
if(Catch2_VERSION VERSION_LESS 3)
  target_link_libraries(dumbbell_catch_main PUBLIC Catch2::Catch2)
  set(catch_options EXTRA_ARGS -w NoTests)  # what version 3 does without being asked
else()
  target_link_libraries(dumbbell_catch_main PUBLIC Catch2::Catch2WithMain)
  set(catch_options "")
endif()
# Most of what a test program takes to build is Catch's macros: a third less without a block for exceptions around each
# assertion (one that throws still fails its test case), and with less optimisation of what a test says itself: none where
# it only starts programs.
target_compile_definitions(dumbbell_catch_main PUBLIC CATCH_CONFIG_FAST_COMPILE)
target_compile_options(dumbbell_catch_main PRIVATE $<$<CONFIG:Release>:-O1>)

# In a build without all wings a test case with the tag [wings], which asks for one, is no test.
if(has_all_wings)
  set(test_spec "")
else()
  set(test_spec TEST_SPEC "~[wings]")
endif()

function(dumbbell_add_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBS;LABELS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "dumbbell_add_tests(${name}): SOURCES missing or unknown words: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()

  add_executable(test_${name} ${arg_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE dumbbell_options dumbbell_catch_main ${arg_LIBS})
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O$<IF:$<STREQUAL:${arg_LABELS},cli>,0,1>>)
  set_target_properties(test_${name} PROPERTIES UNITY_BUILD ${unity_tests})
  set_target_properties(test_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  # A name that matches no test case is a failure: cmake splits one that has a semicolon, and joins one that has an
  # unpaired bracket to those that follow it.
  catch_discover_tests(test_${name} TEST_PREFIX "${name}/" ${test_spec} ${catch_options})

  # ctest reads this after the list that catch_discover_tests made. A program that crashes when it is
  # asked for its tests leaves an empty list there, silently: make that a failure.
  set(after_list ${CMAKE_CURRENT_BINARY_DIR}/test_${name}_after_list.cmake)
  file(CONFIGURE OUTPUT ${after_list} @ONLY CONTENT [[
if(test_@name@_TESTS)
  set_tests_properties(${test_@name@_TESTS} PROPERTIES LABELS "@arg_LABELS@" TIMEOUT 1200
    SKIP_REGULAR_EXPRESSION "skipped: only root can mount a small disk")
else()
  add_test("@name@/LISTS NO TESTS" test_@name@_LISTS_NO_TESTS)
endif()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${after_list})
endfunction()

# dumbbell_add_tool_test(NAME LABEL "TOOL..." COMMAND...): a test that ./run test --all adds, skipped where one of these tools is missing.
function(dumbbell_add_tool_test name label tools)
  add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/with_tools ${tools} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT 3600 SKIP_RETURN_CODE 77)
endfunction()
