#!/usr/bin/env bash
# word_size_test.sh: the verifier's source is C++ also where `long` has 32 bits, and where 64 bits are `long long`: no
# number of GMP's is made of, or compared with, what may be too long for it there. Only read, a folder at a time, with the
# 64-bit system's headers.
set -euo pipefail
root=$(readlink -f -- "$(dirname -- "$0")/../../..")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
headers=/usr/include/$(gcc -print-multiarch)
mkdir -- "$folder/gnu"
touch -- "$folder/gnu/stubs-32.h" # where there is no C library of 32 bits
cd -- "$root/src"
for room in verify/*/; do
    printf '#include "%s"\n' "$room"*.?pp > "$folder/room.cpp"
    g++ -m32 -msse2 -mfpmath=sse -std=c++20 -fsyntax-only -DDUMBBELL_VERSION='"0"' -I. -I"$folder" \
        -isystem "$headers/c++/$(g++ -dumpversion)" -isystem "$headers" "$folder/room.cpp"
done
