# dumbbell_add_fuzz_target(NAME SOURCES file... LIBS target... [MUTATOR file])
#
# A function LLVMFuzzerTestOneInput. With DUMBBELL_FUZZ (preset fuzz: clang, instrumented) it becomes the libFuzzer
# program bin/fuzz_NAME, part of the target `fuzzers`. Otherwise it becomes the test fuzz/NAME, labelled `unit`:
# the inputs in corpus/NAME and regressions/NAME, by an ordinary program.
option(DUMBBELL_FUZZ "build the fuzz targets of tests/fuzz as libFuzzer programs" OFF)

if(DUMBBELL_FUZZ)
  add_custom_target(fuzzers)
endif()

function(dumbbell_add_fuzz_target name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MUTATOR" "SOURCES;LIBS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "dumbbell_add_fuzz_target(${name}): SOURCES missing or unknown words: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(DUMBBELL_FUZZ)
    set(program fuzz_${name})
    add_executable(${program} EXCLUDE_FROM_ALL ${arg_SOURCES} ${arg_MUTATOR})
    target_link_options(${program} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers ${program})
  else()
    set(program replay_${name})
    add_executable(${program} ${arg_SOURCES} ${CMAKE_CURRENT_SOURCE_DIR}/replay.cpp)
    set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    add_dependencies(unit_tests ${program})
    add_test(NAME fuzz/${name}
      COMMAND ${program} ${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name} ${CMAKE_CURRENT_SOURCE_DIR}/regressions/${name})
    set_tests_properties(fuzz/${name} PROPERTIES LABELS unit TIMEOUT 1200)
  endif()
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${program} PRIVATE dumbbell_options ${arg_LIBS})
endfunction()
