#!/usr/bin/env bash
# abi_test.sh COMPILER SOURCE_INCLUDES BUILT_INCLUDES PROVE VERIFY: a program whose standard library lays out its types in
# another way than that of the libraries does not link, whichever function it calls; one that only checks more does.
set -uo pipefail
compiler=$1 includes=("-I$2" "-I$3") libraries=("${@:4}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

program() { # program HEADER CALL
    printf '#include <dumbbell/%s.hpp>\nusing namespace dumbbell::api;\nint main() { %s; }\n' "$1" "$2" > "$folder/main.cpp"
}
links() { "$compiler" -std=c++20 "$@" "${includes[@]}" "$folder/main.cpp" -o "$folder/main" "${libraries[@]}" 2> "$folder/log"; }

while IFS='|' read -r header call; do
    program "$header" "$call"
    for same in -O2 -D_GLIBCXX_ASSERTIONS -O0; do
        links "$same" || { echo "FAILED $call does not link with $same"; cat "$folder/log"; failures=$((failures + 1)); }
    done
    for other in -D_GLIBCXX_DEBUG -D_GLIBCXX_USE_CXX11_ABI=0 '-D_GLIBCXX_DEBUG -D_GLIBCXX_USE_CXX11_ABI=0'; do
        # shellcheck disable=SC2086  # two words
        if links $other; then
            echo "FAILED $call links with $other"
            failures=$((failures + 1))
        elif ! grep -q 'undefined reference' "$folder/log"; then
            echo "FAILED $call does not compile with $other"
            cat "$folder/log"
            failures=$((failures + 1))
        fi
    done
done << 'CALLS'
mass_ratio|MassRatio("10")
bounce|Interval x; (void)ray_from_light_wall(x, x)
certify|save(Proof{}, "")
certify|MassRatio* q = nullptr; (void)certify(*q, {})
trace|MassRatio* q = nullptr; (void)trace(*q, {})
verify|(void)verify("", {})
critical|(void)critical(4)
law|MassRatio* q = nullptr; (void)law(*q)
starts|MassRatio* q = nullptr; (void)certify_incoming(*q)
CALLS
exit $((failures > 0))
