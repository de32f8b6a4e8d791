#!/bin/bash
# shipped_test.sh PROGRAM FOLDER: audits every certificate of the folder that has boxes of mass ratios, that is, all but the law's and cells of bodies; none at all is
# a failure.
set -euo pipefail
shopt -s nullglob
program=$1
files=()
for file in "$2"/*.dbc "$2"/*.dbc.gz; do
    [[ $(gzip -dcf -- "$file" | sed -n 5,6p) =~ 'section cells'|'claim law' ]] || files+=("$file")
done
if ((${#files[@]} == 0)); then
    echo "no certificates in $2" >&2
    exit 1
fi
"$program" audit "${files[@]}"
