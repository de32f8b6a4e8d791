#!/usr/bin/env bash
# subdirectory_test.sh: another project takes this one in by add_subdirectory(), and names its libraries as it does when
# they are installed. Its own folders stay its own.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
root=$(readlink -f -- "$here/../../..")
source "$here/expect.sh"
export CMAKE_GENERATOR=Ninja

parent=$scratch/parent
mkdir -- "$parent"
printf 'int main() {}\n' > "$parent/main.cpp"
configure() { # configure LIBRARY... -- OPTION...
    local libraries=()
    while [[ $1 != -- ]]; do
        libraries+=("$1")
        shift
    done
    shift
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(parent LANGUAGES CXX)' \
        "add_subdirectory(\"$root\" dumbbell EXCLUDE_FROM_ALL)" 'add_executable(parent main.cpp)' \
        "target_link_libraries(parent PRIVATE ${libraries[*]})" > "$parent/CMakeLists.txt"
    rm -rf -- "$parent/build"
    run cmake -S "$parent" -B "$parent/build" "$@"
}
configure dumbbell::verify -- -DDUMBBELL_VERIFIER_ONLY=ON
expect "the verifier's library has its name" is "$code" 0
configure dumbbell::verify dumbbell::prove --
expect "both libraries have their names" is "$code" 0
expect "programs of this project are built in its own folder" grep -q 'build dumbbell/bin/dumbbell-verify:' "$parent/build/build.ninja"
expect "no test of this project is one of the parent's" test ! -e "$parent/build/dumbbell/tests"
finish
