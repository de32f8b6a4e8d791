# dumbbell_add_fuzz_target(NAME SOURCES file... LIBS target... [MUTATOR file])
#
# A function LLVMFuzzerTestOneInput: the libFuzzer program bin/fuzz_NAME, part of the target `fuzzers`, which
# tests/attacks/fuzz/run builds and runs. Only with DUMBBELL_FUZZ (preset sanitizers: clang, instrumented).
option(DUMBBELL_FUZZ "build the fuzz targets of tests/attacks/fuzz as libFuzzer programs" OFF)

if(DUMBBELL_FUZZ)
  add_custom_target(fuzzers)
endif()

function(dumbbell_add_fuzz_target name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MUTATOR" "SOURCES;LIBS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "dumbbell_add_fuzz_target(${name}): SOURCES missing or unknown words: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT DUMBBELL_FUZZ)
    return()
  endif()
  add_executable(fuzz_${name} ${arg_SOURCES} ${arg_MUTATOR})
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  target_include_directories(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(fuzz_${name} PRIVATE dumbbell_options ${arg_LIBS})
  add_dependencies(fuzzers fuzz_${name})
endfunction()
