#!/usr/bin/env bash
# man_test.sh BIN: groff finds nothing wrong with the man pages of both programs.
set -euo pipefail
for page in "dumbbell generate man" "dumbbell-verify --man"; do
    text=$("$1"/$page | groff -ww -man -Tutf8 -P-cbou 2>&1 && "$1"/$page | groff -ww -man -z 2>&1)
    [[ $text == *"EXIT STATUS"* && $text != *": warning: "* && $text != *": error: "* ]] || { printf '%s\n' "$page: $text"; exit 1; }
done
