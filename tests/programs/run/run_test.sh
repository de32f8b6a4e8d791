#!/usr/bin/env bash
# Tests of ./run: set-up, missing packages, failing builds, and that arguments, stdout, working directory
# and exit code pass through. Works in a scratch project next to copies of the real scripts.
set -euo pipefail

source_root=$(readlink -f -- "$(dirname -- "$0")/../../..")
source "$source_root/tests/programs/package/expect.sh"
project="$scratch/a project" # a path with a space
fake=$scratch/fake
unset DUMBBELL_WERROR

mkdir -p -- "$project/.ci" "$scratch/elsewhere" "$fake"
cp -- "$source_root/run" "$source_root/CMakePresets.json" "$project"
cp -- "$source_root"/.ci/{elsewhere.txt,install,packages.txt} "$project/.ci"
cat > "$project/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.25)
project(scratch LANGUAGES CXX)
option(BUILD_TESTING "" ON)
option(DUMBBELL_WERROR "" OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
add_executable(dumbbell main.cpp)
add_executable(dumbbell-verify main.cpp)
if(BUILD_TESTING)
  enable_testing()
  add_test(NAME werror-${DUMBBELL_WERROR} COMMAND dumbbell exit 0)
endif()
END
cat > "$project/main.cpp" << 'END'
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
static bool holds_lock(int fd) {
    char link[64], path[4096] = {};
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    return readlink(link, path, sizeof path - 1) > 0 && std::strstr(path, ".run.lock") != nullptr;
}
int main(int argc, char** argv) {
    char folder[4096];
    if (!getcwd(folder, sizeof folder)) return 1;
    std::printf("cwd=%s\n", std::strrchr(folder, '/') + 1);
    for (int i = 1; i < argc; ++i) std::printf("<%s>\n", argv[i]);
    for (int fd = 3; fd < 30; ++fd)
        if (holds_lock(fd)) std::puts("the lock is still held");
    return argc > 2 && std::strcmp(argv[1], "exit") == 0 ? std::atoi(argv[2]) : 0;
}
END

# run_in FOLDER COMMAND...: leaves $code, $out, $err.
run_in() {
    local folder=$1
    shift
    code=0
    (cd -- "$folder" && "$@") > "$scratch/out" 2> "$scratch/err" < /dev/null || code=$?
    out=$(< "$scratch/out") err=$(< "$scratch/err")
}

# Words
run_in "$scratch" "$project/run"
expect "no word: exit 2" is "$code" 2
expect "no word: help on stderr" has "$err" "usage: ./run WORD"
expect "no word: nothing on stdout" is "$out" ""
expect "no word: nothing was built" test ! -e "$project/build"

# Missing packages. The fake dpkg-query knows all but two, and of alternatives the second.
cat > "$fake/dpkg-query" << 'END'
#!/usr/bin/env bash
for word in "${@:3}"; do
    case $word in
        libmpfr-dev) [[ ! -e $FAKE_STATE ]] || echo "installed $word 4.2" ;;
        libflint-arb-dev) ;;
        libflint-dev) echo "installed $word $FAKE_FLINT" ;;
        catch2) echo "config-files $word 2.13" ;;
        *) echo "installed $word 1:1.0-1" ;;
    esac
done
[[ -e $FAKE_STATE ]]
END
cat > "$fake/apt-get" << 'END'
#!/usr/bin/env bash
echo "apt-get's own chatter"
echo "$* [$DEBIAN_FRONTEND]" >> "$FAKE_LOG"
[[ $* != *update* ]] || exit 100
[[ $FAKE_APT == works ]] || exit 100
touch "$FAKE_STATE"
END
printf '#!/bin/sh\necho "$FAKE_UID"\n' > "$fake/id"
chmod +x "$fake"/*
export FAKE_STATE=$scratch/installed FAKE_LOG=$scratch/apt.log FAKE_UID=1000 FAKE_APT=works FAKE_FLINT=3.1.3-2
with_fakes() { run_in "$scratch/elsewhere" env PATH="$fake:$PATH" "$@"; }

with_fakes "$project/run" certify 10
expect "without root: exit 2" is "$code" 2
expect "without root: names what is missing and why" has "$err" "libmpfr-dev          multiple-precision numbers"
expect "without root: prints the command" has "$err" "apt-get satisfy -y --no-install-recommends 'libmpfr-dev'\""
expect "without root: only what is missing, only what is needed" lacks "$err" catch2
expect "without root: nothing on stdout" is "$out" ""
expect "without root: apt-get is not called" test ! -e "$FAKE_LOG"
expect "without root: nothing was built" test ! -e "$project/build"
with_fakes "$project/run" test
expect "the tests need more packages" has "$err" "satisfy -y --no-install-recommends 'libmpfr-dev, catch2'\""
cp -- "$fake/id" "$fake/catch2"
with_fakes "$project/run" test
expect "a program from elsewhere does as well as its package" lacks "$err" catch2
rm -- "$fake/catch2"
FAKE_FLINT=2.9.0-5
with_fakes "$project/run" certify 10
expect "an alternative that is too old does not do; apt-get is told all" \
    has "$err" "satisfy -y --no-install-recommends 'libmpfr-dev, libflint-arb-dev|libflint-dev(>=3)'\""
FAKE_FLINT=3.1.3-2

# Every group can be had on Debian 12 and on Debian 13: one of the alternatives is there.
mkdir -- "$scratch/suite"
printf '#!/bin/sh\nawk -v n="$FAKE_SUITE" \x27!/^#/ && $n != "-" { print "installed", $1, $n }\x27 "%s"\n' \
    "$source_root/tests/programs/run/suites.tsv" > "$scratch/suite/dpkg-query"
chmod +x "$scratch/suite/dpkg-query"
groups=$(awk '!/^#/ && NF { gsub(",", " ", $1); print $1 }' "$source_root/.ci/packages.txt" | xargs)
for FAKE_SUITE in 2 3; do
    run_in "$scratch" env PATH="$scratch/suite:$fake:$PATH" FAKE_SUITE=$FAKE_SUITE "$project/.ci/install" $groups
    expect "all that is listed can be had on Debian $((FAKE_SUITE + 10))" is "$code$err" 0
done

# Where there is no apt: the names of what is missing, and no error of a shell.
mkdir -- "$scratch/other"
for program in bash cat dirname env nproc readlink flock; do
    ln -s -- "$(type -P "$program")" "$scratch/other"
done
run_in "$scratch" env PATH="$scratch/other" "$project/run" certify 10
expect "no apt: exit 2" is "$code" 2
expect "no apt: the names elsewhere" grep -qE 'ninja +ninja-build +ninja +ninja +ninja$' "$scratch/err"
expect "no apt: libraries, too" has "$err" nettle-devel
expect "no apt: nothing is not found by the shell" lacks "$err" "command not found"

FAKE_UID=0 FAKE_APT=fails
with_fakes "$project/run" certify 10
expect "apt-get fails: exit 1" is "$code" 1
expect "apt-get fails: its output is shown" has "$err" "apt-get's own chatter"
FAKE_APT=works
with_fakes "$project/run" certify 10
expect "as root: installs and goes on, though apt-get update failed" is "$code" 0
expect "as root: says so" has "$err" "installing them with apt-get"
expect "as root: waits for the lock, asks nothing" \
    grep -qxF -- "-o DPkg::Lock::Timeout=300 satisfy -y --no-install-recommends libmpfr-dev [noninteractive]" "$FAKE_LOG"
expect "as root: stdout is the program's alone" is "$out" $'cwd=elsewhere\n<certify>\n<10>'
: > "$FAKE_LOG"
with_fakes "$project/run" certify 10
expect "installed: silent" is "$err" ""
expect "installed: apt-get is not called" test ! -s "$FAKE_LOG"

# The build and what passes through
rm -rf -- "$project/build"
run_in "$scratch/elsewhere" "$project/run" certify 1:100 --out "my file" ""
expect "first run: exit 0" is "$code" 0
expect "first run: arguments and working directory pass through" \
    is "$out" $'cwd=elsewhere\n<certify>\n<1:100>\n<--out>\n<my file>\n<>'
expect "first run: says that it builds" has "$err" "run: building in $project/build"
expect "first run: without the tests" grep -qx BUILD_TESTING:BOOL=OFF "$project/build/CMakeCache.txt"
ln -s -- "$project/run" "$scratch/elsewhere/link"
run_in "$scratch/elsewhere" ./link exit 3
expect "through a link, nothing to do: the program's exit code" is "$code" 3
expect "through a link, nothing to do: silent" is "$err" ""
expect "the program does not inherit the lock" lacks "$out" "lock is still held"
run_in "$project" bash run --help
expect "--help goes to the program" is "$out" $'cwd=a project\n<--help>'
run_in "$project" ./run build
expect "build: exit 0, nothing on stdout" is "$code$out" 0
run_in "$project" ./run build more
expect "build: no arguments" is "$code" 2
run_in "$project" ./run package now
expect "package takes no arguments" is "$code" 2
run_in "$project" ./run python now
expect "python takes no arguments" is "$code" 2
run_in "$project" ./run static sparc
expect "static: for this machine, or aarch64" is "$code$err" "2run: static makes the verifier for this machine, or for aarch64"
run_in "$project" ./run release
expect "a release is of a commit" is "$code" 2
run_in "$project" ./run bench
expect "bench, none there: exit 1" is "$code" 1
expect "bench, none there: says so" has "$err" "no benchmarks"

# Tests
run_in "$scratch/elsewhere" "$project/run" test
expect "test: exit 0" is "$code" 0
expect "test: ctest's summary" has "$out" "100% tests passed, 0 tests failed out of 1"
run_in "$scratch/elsewhere" env DUMBBELL_WERROR=ON "$project/run" test -N
expect "test: options for ctest; warnings as errors" has "$out" "werror-ON"
run_in "$scratch/elsewhere" "$project/run" test -R no-such-test
expect "test: no tests is a failure" test "$code" -ne 0
run_in "$scratch/elsewhere" "$project/run" --version
expect "a folder with tests keeps them" grep -qx BUILD_TESTING:BOOL=ON "$project/build/CMakeCache.txt"
expect "a folder with tests: nothing to do, silent" is "$err" ""

# CI, where everything else only says how it was called: the second time a test is run is what counts, and so is a failure of
# anything that is no test.
ci=$scratch/ci
mkdir -p -- "$ci"/{.ci,bin,tests/attacks/fuzz,build/sanitizers/bin}
cp -- "$source_root/.ci/run" "$ci/.ci"
for stub in .ci/{install,format} bin/{cmake,doxygen} tests/attacks/fuzz/run build/sanitizers/bin/dumbbell-verify; do
    printf '#!/bin/sh\n' > "$ci/$stub"
done
printf '#!/bin/sh\nexit 3\n' > "$ci/.ci/trixie"
cat > "$ci/run" << 'END'
#!/usr/bin/env bash
echo "$*" >> calls
test_case() { printf '\t<testcase name="%s" classname="" time="1" status="%s">\n' "$@" >> "$report"; }
report=${*: -1}
case "$*" in
    python) exit "$FAKE_PYTHON" ;;
    *-L*) test_case web/a run ;;
    test*) test_case web/a notrun && test_case cli/b run && test_case "cli/c d" "$FAKE_TEST" && [[ $FAKE_TEST == run ]] ;;
esac
END
find "$ci" -type f -exec chmod +x {} +
run_in "$ci" env PATH="$ci/bin:$PATH" FAKE_PYTHON=0 FAKE_TEST=run .ci/run
expect "CI: passed, but for what could not be had" is "$code $(tail -n 1 <<< "$out")" "0 13 passed, 0 failed, 1 skipped"
expect "CI: the tests come first" is "$(head -c 4 "$ci/calls")" test
run_in "$ci" env PATH="$ci/bin:$PATH" FAKE_PYTHON=1 FAKE_TEST=fail .ci/run
expect "CI: two failures, one of a test" is "$code $(tail -n 1 <<< "$out")" "1 11 passed, 2 failed, 1 skipped"
expect "CI: a test that was skipped to the end is a failure" \
    has "$(PATH=$ci/bin:$PATH FAKE_PYTHON=0 FAKE_TEST=notrun "$ci/.ci/run" 2>&1)" "FAILED: cli/c d, which was skipped"
expect "CI: the failures by name" has "$out" $'FAILED: the module for Python\nFAILED: cli/c d\n'

# A moved project
mv -- "$project" "$scratch/moved"
project=$scratch/moved
run_in "$scratch/elsewhere" "$project/run" certify
expect "moved project: configured again" is "$code" 0
expect "moved project: like a new one" grep -qx BUILD_TESTING:BOOL=OFF "$project/build/CMakeCache.txt"

# Two at once
touch "$project/main.cpp"
(cd -- "$project" && ./run certify > "$scratch/out1" 2>&1) &
run_in "$project" ./run certify
wait $!
expect "two at once: both succeed" is "$code" 0

# Ctrl-C while it builds: the whole group of processes is told
mkdir -- "$scratch/stopping"
printf '#!/bin/sh\nkill -INT 0\nsleep 10\n' > "$scratch/stopping/cmake"
chmod +x "$scratch/stopping/cmake"
touch "$project/main.cpp"
run_in "$scratch/elsewhere" setsid --wait env PATH="$scratch/stopping:$PATH" "$project/run" certify
expect "stopped: exit 130" is "$code" 130
expect "stopped: one line, and no log" is "$err" "run: stopped; the same command goes on with the build"

# A failing build, then a repaired one
cp -- "$project/main.cpp" "$scratch/main.cpp"
echo 'int broken = "text";' >> "$project/main.cpp"
run_in "$scratch/elsewhere" "$project/run" certify
expect "compile error: exit 1" is "$code" 1
expect "compile error: shown on stderr" has "$err" "invalid conversion"
expect "compile error: nothing on stdout" is "$out" ""
cp -- "$scratch/main.cpp" "$project/main.cpp"
run_in "$scratch/elsewhere" "$project/run" certify
expect "repaired: exit 0" is "$code" 0
echo 'message(FATAL_ERROR "no such luck")' >> "$project/CMakeLists.txt"
run_in "$scratch/elsewhere" "$project/run" certify
expect "configure error: exit 1" is "$code" 1
expect "configure error: shown on stderr" has "$err" "no such luck"
rm -rf -- "$project/build"
run_in "$scratch/elsewhere" "$project/run" certify
expect "configure error in an empty folder: exit 1" is "$code" 1
sed -i '$d' "$project/CMakeLists.txt"
run_in "$scratch/elsewhere" "$project/run" certify
expect "after a failed configuration: exit 0" is "$code" 0

finish
