#!/usr/bin/env bash
# valgrind_test.sh DUMBBELL VERIFIER CERTIFICATES: both programs say under valgrind, which knows no rounding but to
# nearest, what they say without it.
set -uo pipefail
dumbbell=$1 verifier=$2 certificates=$3
failures=0
same() {
    local usual found
    usual=$("$@" 2>&1)
    found=$(valgrind -q "$@" 2>&1) && [[ ${found%,*} == "${usual%,*}" ]] && return # but for the time it took
    printf 'FAILED %s\n%s\n' "$*" "$found"
    failures=$((failures + 1))
}
same "$dumbbell" --version
same "$dumbbell" certify 10 --quiet --jobs 1
same "$dumbbell" audit "$certificates/stairs-1-100.dbc"
same "$verifier" --quiet "$certificates/stairs-1-100.dbc"
exit $((failures > 0))
