#!/bin/bash
# shipped_test.sh PROGRAM FOLDER: audits every certificate of the folder; none at all is a failure.
set -euo pipefail
shopt -s nullglob
program=$1
files=("$2"/*.dbc "$2"/*.dbc.gz)
if ((${#files[@]} == 0)); then
    echo "no certificates in $2" >&2
    exit 1
fi
"$program" audit "${files[@]}"
