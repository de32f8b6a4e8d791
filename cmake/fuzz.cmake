# dumbbell_add_fuzz_target(NAME SOURCES file... LIBS target... [MUTATOR file])
#
# A function LLVMFuzzerTestOneInput, and the test fuzz/NAME, labelled `unit`: the inputs that seeds.py makes, and those in
# regressions/NAME. With DUMBBELL_FUZZ (preset sanitizers: clang, instrumented) it becomes the libFuzzer program
# bin/fuzz_NAME, part of the target `fuzzers`; otherwise an ordinary program that only runs these inputs.
option(DUMBBELL_FUZZ "build the fuzz targets of tests/attacks/fuzz as libFuzzer programs" OFF)

if(DUMBBELL_FUZZ)
  add_custom_target(fuzzers)
endif()

set(fuzz_seeds ${PROJECT_BINARY_DIR}/fuzz-seeds)
add_test(NAME fuzz/seeds COMMAND ${DUMBBELL_PYTHON} ${PROJECT_SOURCE_DIR}/tests/attacks/fuzz/seeds.py ${fuzz_seeds})
set_tests_properties(fuzz/seeds PROPERTIES LABELS unit FIXTURES_SETUP fuzz_seeds)

function(dumbbell_add_fuzz_target name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MUTATOR" "SOURCES;LIBS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "dumbbell_add_fuzz_target(${name}): SOURCES missing or unknown words: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(inputs ${fuzz_seeds}/${name})
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/regressions/${name}) # a case of this target was found
    list(APPEND inputs ${CMAKE_CURRENT_SOURCE_DIR}/regressions/${name})
  endif()
  if(DUMBBELL_FUZZ)
    set(program fuzz_${name})
    add_executable(${program} ${arg_SOURCES} ${arg_MUTATOR})
    target_link_options(${program} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers ${program})
    set(replay ${program} -runs=0)
  else()
    set(program replay_${name})
    add_executable(${program} ${arg_SOURCES} ${CMAKE_CURRENT_SOURCE_DIR}/replay.cpp)
    set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    set(replay ${program})
  endif()
  add_dependencies(unit_tests ${program})
  add_test(NAME fuzz/${name} COMMAND ${replay} ${inputs})
  set_tests_properties(fuzz/${name} PROPERTIES LABELS unit TIMEOUT 3600 FIXTURES_REQUIRED fuzz_seeds)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${program} PRIVATE dumbbell_options ${arg_LIBS})
endfunction()
