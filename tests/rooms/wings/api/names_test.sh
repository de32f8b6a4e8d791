#!/usr/bin/env bash
# names_test.sh LIBRARY...: each exports names of dumbbell::api, and no other one of this project.
set -euo pipefail
for library in "$@"; do
    names=$(nm -DC --defined-only -- "$library" | cut -d ' ' -f 3- | grep dumbbell)
    grep -q '^dumbbell::api::' <<< "$names" || { echo "$library exports nothing"; exit 1; }
    if others=$(grep -vE '^((typeinfo|typeinfo name|vtable) for )?dumbbell::api::' <<< "$names"); then
        printf '%s exports:\n%s\n' "$library" "$others"
        exit 1
    fi
done
