#!/usr/bin/env bash
# abi_test.sh COMPILER SOURCE_INCLUDES BUILT_INCLUDES PROVE VERIFY FLAG: a program whose standard library lays out its types in
# another way than that of the libraries does not link, whichever function it calls; one that only checks more does.
set -uo pipefail
compiler=$1 includes=("-I$2" "-I$3") libraries=("$4" "$5") flag=$6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

headers=(bounce certify critical law mass_ratio starts trace verify)
functions=(MassRatio ray_from_light_wall save certify trace verify critical law certify_incoming)
{
    printf '#include <dumbbell/%s.hpp>\n' "${headers[@]}"
    printf 'using namespace dumbbell::api;\nint main() {\n    const MassRatio q("10");\n    const Interval x;\n'
    printf '    (void)%s;\n' 'ray_from_light_wall(x, x)' 'certify(q, {})' 'trace(q, {})' 'verify("", {})' 'critical(4)' 'law(q)' \
        'certify_incoming(q)'
    printf '    save(Proof{}, "");\n}\n'
} > "$folder/main.cpp"

if "$compiler" -std=c++20 -O0 "$flag" "${includes[@]}" "$folder/main.cpp" -o "$folder/main" "${libraries[@]}" 2> "$folder/log"; then
    [[ $flag == -D_GLIBCXX_ASSERTIONS ]] && exit 0
    echo "FAILED: links with $flag"
    exit 1
fi
for function in "${functions[@]}"; do
    [[ $flag != -D_GLIBCXX_ASSERTIONS ]] && grep -q "undefined reference to .*\b$function(" "$folder/log" && continue
    echo "FAILED: with $flag $function is found, or the program does not compile, or does not link"
    cat "$folder/log"
    failures=$((failures + 1))
done
exit $((failures > 0))
