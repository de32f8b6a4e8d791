#!/usr/bin/env bash
# abi_test.sh COMPILER SOURCE_INCLUDES BUILT_INCLUDES PROVE VERIFY: a program whose standard library lays out its types in
# another way than that of the libraries does not link, whichever function it calls; one that only checks more does.
set -uo pipefail
compiler=$1 includes=("-I$2" "-I$3") libraries=("${@:4}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

headers=(certify critical law mass_ratio starts trace verify)
functions=(MassRatio save certify trace verify critical law certify_incoming)
{
    printf '#include <dumbbell/%s.hpp>\n' "${headers[@]}"
    printf 'using namespace dumbbell::api;\nint main() {\n    const MassRatio q("10");\n'
    printf '    (void)%s;\n' 'certify(q, {})' 'trace(q, {})' 'verify("", {})' 'critical(4)' 'law(q)' \
        'certify_incoming(q)'
    printf '    save(Proof{}, "");\n}\n'
} > "$folder/main.cpp"
links() { "$compiler" -std=c++20 "$@" "${includes[@]}" "$folder/main.cpp" -o "$folder/main" "${libraries[@]}" 2> "$folder/log"; }

for same in -O2 -D_GLIBCXX_ASSERTIONS -O0; do
    links "$same" || { echo "FAILED: does not link with $same"; cat "$folder/log"; failures=$((failures + 1)); }
done
for other in -D_GLIBCXX_DEBUG -D_GLIBCXX_USE_CXX11_ABI=0 '-D_GLIBCXX_DEBUG -D_GLIBCXX_USE_CXX11_ABI=0'; do
    # shellcheck disable=SC2086  # two words
    if links $other; then
        echo "FAILED: links with $other"
        failures=$((failures + 1))
    fi
    for function in "${functions[@]}"; do
        grep -q "undefined reference to .*\b$function(" "$folder/log" && continue
        echo "FAILED: with $other $function is found, or the program does not compile"
        cat "$folder/log"
        failures=$((failures + 1))
    done
done
exit $((failures > 0))
