#!/usr/bin/env bash
# package_test.sh BUILD_FOLDER: installs what was built there, and uses it from another project as its CI would:
# find_package(dumbbell), certificates that are right, tampered with or too weak, wrong calls, and the libraries.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
root=$(readlink -f -- "$here/../../..")
build=$1
source "$here/expect.sh"
export CMAKE_GENERATOR=Ninja # and not make, which need not be there

prefix="$scratch/a prefix" # a path with a space
user=$scratch/user
run cmake --install "$build" --prefix "$prefix"
expect "installs" is "$code" 0
expect "both programs are there" test -x "$prefix/bin/dumbbell-verify" -a -x "$prefix/bin/dumbbell"
expect "both man pages are there" test -s "$prefix/share/man/man1/dumbbell.1" -a -s "$prefix/share/man/man1/dumbbell-verify.1"
expect "the pages find the certificates that they name" test -s "$prefix/share/doc/dumbbell/certificates/q-10.dbc"
# What cpack makes of the pages, in a folder with the names that it gives.
mkdir -p -- "$scratch/staged/programs/usr"
cp -a -- "$prefix/share" "$scratch/staged/programs/usr"
run cmake -DCPACK_DUMBBELL_PACKAGES="programs;dumbbell" -DCPACK_DUMBBELL_FOLDER="$root" \
    -DCPACK_TEMPORARY_INSTALL_DIRECTORY="$scratch/staged" -DCPACK_PACKAGING_INSTALL_PREFIX=/usr -DCPACK_PACKAGE_VERSION=0 \
    -P "$root/cmake/debian-files.cmake"
expect "the files that Debian wants are made" is "$code" 0
pages=$scratch/staged/programs/usr/share/doc/dumbbell
run python3 "$root/tests/programs/docs/links_test.py" "$pages"
expect "no link in a packaged page is dead" is "$code" 0
expect "a link to what is packaged stays" grep -q '](docs/10-law.md)' "$pages/README.md"
run "$prefix/bin/dumbbell" verify --ratio 10 --exactly 4 "$prefix/share/dumbbell/certificates/q-10.dbc"
expect "the installed program finds its verifier" is "$code" 0
run "$here/search_paths" "$prefix"
expect "no program looks for its libraries in the current folder" is "$code" 0

# configure [LINE]...: the project that the docs show, or one of these lines.
configure() {
    rm -rf -- "$user"
    mkdir -- "$user"
    cp -- "$root"/docs/ci/{CMakeLists.txt,claims.tsv} "$root"/certificates/{q-10,stairs-1-100}.dbc "$user"
    if (($# > 0)); then
        printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(user LANGUAGES NONE)' 'enable_testing()' \
            'find_package(dumbbell REQUIRED)' "$@" > "$user/CMakeLists.txt"
    fi
    run cmake -S "$user" -B "$user/build" "-DCMAKE_PREFIX_PATH=$prefix"
}
check() { run ctest --test-dir "$user/build" --output-on-failure --no-tests=error; }

configure
expect "the docs' project finds the package" is "$code" 0
check
expect "the docs' project passes" has "$out" "100% tests passed, 0 tests failed out of 3"

# One certificate as it is, one tampered with.
tampered() { # tampered FROM TO: a copy of q-10.dbc with a line changed, and a checksum that is right for it
    head -n -1 "$root/certificates/q-10.dbc" | sed "s/^$1\$/$2/" > "$user/body"
    { cat -- "$user/body"; printf 'sha256 %s\n' "$(sha256sum < "$user/body" | cut -d ' ' -f 1)"; } > "$user/tampered.dbc"
}
configure 'dumbbell_add_proof_check(right q-10.dbc RATIO 10 EXACTLY 4)' \
    "dumbbell_add_proof_check(wrong $user/tampered.dbc RATIO 10 MAX 3)"
expect "an absolute name may come into being later" is "$code" 0
tampered 'upper 4' 'upper 3'
check
expect "tampered with: ctest fails" is "$code" 8
expect "tampered with: one of two" has "$out" "50% tests passed, 1 tests failed out of 2"
expect "tampered with: the right one passes" grep -Eq ': right \.+ +Passed' <<< "$out"
expect "tampered with: the wrong one fails, and not by a crash or a time limit" grep -Eq ': wrong \.+\*\*\*Failed' <<< "$out"
expect "tampered with: because a leaf does not hold" has "$out" "s REJECTED line=13 code=count not certified: 1 + a + b <= U"
tampered 'lower 4' 'lower 5'
check
expect "lower above upper: rejected" has "$out" "s REJECTED line=16 code=number lower above upper"
sed 's/^upper 4$/upper 5/' "$root/certificates/q-10.dbc" > "$user/tampered.dbc"
check
expect "weakened, old checksum: rejected for it" has "$out" " code=sha256 "
cp -- "$root/certificates/q-10.dbc" "$user/tampered.dbc"
check
expect "a right certificate that proves less than asked: rejected" has "$out" \
    "code=claim-not-proved not proved: at most 3 collisions for every mass ratio in 10/1:10/1"
rm -- "$user/tampered.dbc"
check
expect "a missing certificate fails" has "$out" "s UNREADABLE No such file or directory"

configure 'dumbbell_add_proof_check(both q-10.dbc stairs-1-100.dbc RATIO 10 EXACTLY 4 SCENE dumbbell)'
check
expect "several certificates in one test" has "$out" "100% tests passed, 0 tests failed out of 1"
configure "dumbbell_add_proof_check(gap stairs-1-100.dbc RATIO 1:100 MAX 10 GAP 1e-6 GAPS 8)" \
    "dumbbell_add_proof_check(coin $root/certificates/coin.dbc COIN EXACTLY 4 TIMEOUT 60)" \
    "dumbbell_add_proof_check(rod RATIO 10 ROD_MASS 1/100 EXACTLY 5 $root/certificates/rod-10.dbc.gz)"
check
expect "any demand of the verifier" has "$out" "100% tests passed, 0 tests failed out of 3"
configure 'dumbbell_add_proof_check(both q-10.dbc stairs-1-100.dbc RATIO 11 MAX 4)'
check
expect "one of several is for another ratio: rejected" has "$out" "c files=2 verified=1 rejected=1"

# Wrong use is an error when CMake configures.
refused() { # refused ARGUMENTS MESSAGE
    configure "dumbbell_add_proof_check($1)"
    expect "refused: $1" test "$code" -ne 0
    expect "says: $2" has "${out//$'\n'/ }" "$2"
}
refused 'ten RATIO 10 MAX 4' 'no certificate'
refused 'ten "" RATIO 10 MAX 4' 'no certificate'
refused 'ten q-10.dbc "" RATIO 10 MAX 4' '`` is neither a certificate'
refused 'ten q-10.dbc MAX 4' 'the claim needs --ratio or a body'
refused 'ten q-10.dbc RATIO 10' 'and --max, --min, --exactly or --decided'
refused 'ten q-10.dbc' 'no claim: say what they prove'
refused 'ten q-10.dbc RATIO 10 MAX' 'no value after --max'
refused 'ten q-10.dbc RATIO 10 MIN 2 MAX ""' 'no value after --max'
refused 'ten q-10.dbc RATIO 10 MAX 4 MAX 5' '--max is given twice'
refused 'ten q-10.dbc RATIO 10 MAX 4x' 'not `4x`'
refused 'ten q-10.dbc RATIO ten MAX 4' 'not a positive ratio: `ten`'
refused 'ten q-10.dbc RATIO 10 EXACTLY 4 MAX 5' '--exactly N is --max N and --min N'
refused 'ten q-10.dbc RATIO 10 MAX 4 SCENE flat' 'not `flat`'
refused 'ten q-10.dbc RATIO 10 MAX 4 TIMEOUT 0' 'TIMEOUT cannot be `0`'
refused 'ten q-10.dbc RATIO 10 MAX 4 TIMEOUT 1 TIMEOUT 2' 'TIMEOUT is given twice'
refused 'ten q-10.dbc RATIO 10 MAXIMUM 4' '`--maximum` states no claim'
refused 'ten q-10.dbc RATIO 10 MAX 4 HELP' '`--help` states no claim'
refused 'ten q-10.dbc RATIO 10 MAX 4 5' '`5` is neither a certificate (.dbc or .dbc.gz) nor the value'
refused 'ten q-10.dbc RATIO 10 MAX "4\tmore"' 'has a tab'
refused 'ten other.dbc RATIO 10 MAX 4' 'there is no file'
refused 'NAME q-10.dbc RATIO 10 MAX 4' 'the first argument is the name itself'
refused 'list CLAIMS none.tsv' 'there is no file'
refused 'list CLAIMS claims.tsv RATIO 10' 'CLAIMS names the certificates and the claims'
refused 'list CLAIMS' 'no value after CLAIMS'
refused 'list q-10.dbc CLAIMS claims.tsv' 'CLAIMS names the certificates'

configure 'dumbbell_add_proof_check(list CLAIMS claims.tsv)'
expect "a list is accepted" is "$code" 0
printf 'q-10.dbc\t--ratio 10\n' > "$user/claims.tsv"
check
expect "a list without a claim fails" has "$out" "claims.tsv:1: the claim needs --ratio or a body, and --max, --min, --exactly or --decided"

sed -i /enable_testing/d "$user/CMakeLists.txt"
run cmake --fresh -S "$user" -B "$user/build" "-DCMAKE_PREFIX_PATH=$prefix"
expect "refused: tests that would not be run" has "$out" "call enable_testing() before"
for request in '9.0 REQUIRED' 'REQUIRED COMPONENTS more' 'REQUIRED COMPONENTS verify prove more'; do
    configure
    sed -i "s/find_package(.*/find_package(dumbbell $request)/" "$user/CMakeLists.txt"
    run cmake --fresh -S "$user" -B "$user/build" "-DCMAKE_PREFIX_PATH=$prefix"
    expect "not found: $request" test "$code" -ne 0
done

# A program that uses the libraries, as the docs show it.
rm -rf -- "$user"
cp -r -- "$root/docs/library" "$user"
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
flags="$(cached CMAKE_CXX_FLAGS) -Wall -Wextra -Wpedantic -Werror" # sanitizers want to be in the program too
run cmake -S "$user" -B "$user/build" "-DCMAKE_PREFIX_PATH=$prefix" "-DCMAKE_CXX_COMPILER=$(cached CMAKE_CXX_COMPILER)" \
    "-DCMAKE_CXX_FLAGS=$flags"
expect "the docs' program finds the libraries" is "$code" 0
run cmake --build "$user/build"
expect "it compiles without warnings" is "$code" 0
run "$user/build/bounce"
expect "it runs" is "$code" 0
expect "it encloses the bounces" has "$out" " mass at time ["
expect "it proves, and the verifier agrees" has "$out" "verified: scene=dumbbell ratio=10/1:10/1 upper=4 lower=4 "
expect "its certificate is the shipped one" cmp -s "$scratch/ten.dbc" "$root/certificates/q-10.dbc"
if command -v pkg-config > /dev/null; then
    libraries=$(find "$prefix" -name pkgconfig)
    run env PKG_CONFIG_PATH="$libraries" pkg-config --cflags --libs dumbbell-prove dumbbell-verify
    expect "pkg-config finds the libraries" is "$code" 0
    # A path with a space comes with a backslash.
    run bash -c "$(cached CMAKE_CXX_COMPILER) $flags -std=c++20 '$user/bounce.cpp' -o bounce $out '-Wl,-rpath,${libraries%/*}' && ./bounce"
    expect "a program compiled with what it says proves" has "$out" "verified: scene=dumbbell ratio=10/1:10/1"
fi
for header in "$prefix"/include/dumbbell/*.hpp; do
    run "$(cached CMAKE_CXX_COMPILER)" -std=c++20 -fsyntax-only -x c++ "-I$prefix/include" "$header"
    expect "${header##*/} stands by itself" is "$code" 0
done
expect "no header names a library that a user would have to install" \
    test -z "$(grep -hE '#include <(boost|gmp|mpfr|mpfi|fmt|Eigen|CLI|nettle)' "$prefix"/include/dumbbell/*.hpp)"

finish
