# What the results rest on, whatever CMAKE_CXX_FLAGS say: these stand behind them. Of what they undo clang tells a program
# nothing.
set(arithmetic
  -fno-fast-math -fno-unsafe-math-optimizations -fno-associative-math -fno-reciprocal-math -fno-finite-math-only
  -fsigned-zeros
  # Bounds must not depend on where a compiler chooses to fuse a*b+c: results are bit-identical at every
  # optimisation level.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  list(PREPEND arithmetic -fno-approx-func -fdenormal-fp-math=ieee)
endif()

# dumbbell_options: what every target of this project is compiled with; each library links it PUBLIC.
add_library(dumbbell_options INTERFACE)
target_compile_features(dumbbell_options INTERFACE cxx_std_20)
target_compile_definitions(dumbbell_options INTERFACE DUMBBELL_VERSION="${PROJECT_VERSION}")
target_compile_options(dumbbell_options INTERFACE
  ${arithmetic}
  -Wall -Wextra -Wpedantic -Wconversion
  # Not of clang for several files at a time: there a local name hides, harmlessly, what another file has in its
  # anonymous namespace.
  $<$<NOT:$<AND:$<CXX_COMPILER_ID:Clang>,$<BOOL:${CMAKE_UNITY_BUILD}>>>:-Wshadow>
  -Wno-sign-conversion  # clang counts it to -Wconversion, g++ does not: one meaning for both
  $<$<BOOL:${DUMBBELL_WERROR}>:-Werror>)

# dumbbell_provenance: for the programs' --version, which says how the program was made, and under which licence it is so.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
list(JOIN arithmetic " " behind)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${behind}" flags)
add_library(dumbbell_provenance INTERFACE)
target_compile_definitions(dumbbell_provenance INTERFACE
  DUMBBELL_COMPILER="${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
  DUMBBELL_BUILD_TYPE="${CMAKE_BUILD_TYPE}"
  DUMBBELL_LICENCE="$<IF:$<TARGET_EXISTS:CGAL::CGAL>,GPL-3.0-or-later by its CGAL,MIT>"
  DUMBBELL_FLAGS="${flags}")
