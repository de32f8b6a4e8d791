#!/usr/bin/env bash
# valgrind_test.sh COMMAND...: it says under valgrind, which knows no rounding but to nearest, what it says without it.
set -uo pipefail
usual=$("$@" 2>&1)
found=$(valgrind -q "$@" 2>&1) && [[ ${found%,*} == "${usual%,*}" ]] && exit 0 # but for the time it took
printf 'FAILED %s\n%s\n' "$*" "$found"
exit 1
