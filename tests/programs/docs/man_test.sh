#!/usr/bin/env bash
# man_test.sh BIN: groff finds nothing wrong with the man pages of both programs.
set -euo pipefail
errors=$(mktemp)
trap 'rm -f -- "$errors"' EXIT
for page in "dumbbell generate man" "dumbbell-verify --man"; do
    text=$("$1"/$page | groff -ww -man -Tutf8 -P-cbou 2> "$errors")
    [[ $text == *"EXIT STATUS"* && ! -s $errors ]] || { printf '%s\n' "$page:" "$(< "$errors")"; exit 1; }
done
