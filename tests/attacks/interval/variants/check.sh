#!/usr/bin/env bash
# check.sh PROJECT COMPILER...: the interval layers in double give the same bits whatever compiler and optimisation
# level; with contraction they still enclose; with flags that break IEEE arithmetic they do not compile, refuse to
# compute, or still enclose.
set -uo pipefail
project=$1 compilers=("${@:2}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
here=$(dirname -- "${BASH_SOURCE[0]}")
program=("$here/program.cpp" "$project"/src/number/{elementary,interval,self_test}.cpp)
verifier=("$here/verifier.cpp" "$project/src/verify/machine/arithmetic.cpp")
declare -A first

fail() {
    printf 'FAILED %s\n' "$*"
    failures=$((failures + 1))
}

# variant KIND COMPILER FLAG...: builds and runs the evaluations of both layers; prints a line for each. KIND is
#   same        the results must have the bits of the first such variant
#   contracted  they must enclose; so without the self-test, which may refuse fused products
#   hostile     the evaluations must not compile, or be refused by the self-test, or enclose
#   refused     the self-test must see that they need not enclose
variant() {
    local kind=$1 layer output code option
    shift
    for layer in program verifier; do
        local -n sources=$layer
        if ! "$@" -std=c++20 -I"$project/src" "${sources[@]}" -o "$folder/$layer" -lmpfr -lgmp 2> "$folder/log"; then
            if [[ $kind == hostile || $kind == refused ]] && grep -qE 'dumbbell.*(-ffast-math|IEEE 754)|needs IEEE 754' "$folder/log"; then
                say "$layer" 'does not compile, as it should' "$*"
            else
                fail "$layer, $*: does not compile"
                head -20 "$folder/log"
            fi
            continue
        fi
        option=--contain
        [[ $kind != contracted ]] || option=--contracted
        output=$("$folder/$layer" "$option" 2>&1)
        code=$?
        if [[ $code == 3 && ($kind == hostile || $kind == refused) ]]; then
            say "$layer" "refuses" "$*"
        elif [[ $kind == refused ]]; then
            fail "$layer, $*: is not refused"
        elif [[ $code != 0 ]]; then
            fail "$layer, $*: exit code $code"
            grep -v results <<< "$output"
        elif [[ $kind == same && -n ${first[$layer]-} && $output != "${first[$layer]}" ]]; then
            fail "$layer, $*: other bits"
            diff <(echo "${first[$layer]}") <(echo "$output")
        else
            [[ $kind != same ]] || first[$layer]=${first[$layer]-$output}
            say "$layer" "$(results "$output") results, 0 refuted$([[ $kind != same ]] || echo ', the same bits')" "$*"
        fi
    done
}
say() { printf '%-9s %-42s %s\n' "$@"; }
results() { awk '/results/ { n += $(NF - 2) } END { print n }' <<< "$1"; }

regrouping=(-fassociative-math -fno-signed-zeros -fno-trapping-math)
native=-march=native
"${compilers[0]}" $native -E -x c++ /dev/null > /dev/null 2>&1 || native=

for compiler in "${compilers[@]}"; do
    for level in -O0 -O2 "-O3 $native"; do
        variant same "$compiler" $level -ffp-contract=off
    done
    variant contracted "$compiler" -O3 $native -ffp-contract=fast
    variant hostile "$compiler" -O2 -ffp-contract=off "${regrouping[@]}"
    variant refused "$compiler" -O2 -ffp-contract=off -freciprocal-math
    variant hostile "$compiler" -O2 -ffp-contract=off -ffinite-math-only
    variant hostile "$compiler" -O2 -ffp-contract=off -fno-signed-zeros
    variant hostile "$compiler" -O2 -ffp-contract=off -ffast-math
done
variant same g++ -O2 -ffp-contract=off -frounding-math # CGAL's headers ask for it
# The self-test alone, without what g++ tells of its flags.
variant refused g++ -O2 -ffp-contract=off "${regrouping[@]}" -U__ASSOCIATIVE_MATH__
variant refused g++ -O2 -ffp-contract=off -freciprocal-math -U__RECIPROCAL_MATH__
variant hostile g++ -O2 -ffp-contract=off -fno-signed-zeros -U__NO_SIGNED_ZEROS__
# Double rounding by the x87 unit, where there is one.
[[ $(uname -m) != x86_64 ]] || variant hostile g++ -O2 -ffp-contract=off -mfpmath=387

printf 'variants: %d failures\n' "$failures"
exit $((failures > 0))
