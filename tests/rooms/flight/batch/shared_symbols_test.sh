#!/usr/bin/env bash
# shared_symbols_test.sh NM OBJECT...: no object that is compiled for wide instructions offers the linker a function that
# another object could share (a weak symbol without a pack in its name): on an older machine the whole program
# might run that one. One line for each that does, and exit code 1.
set -euo pipefail
nm=$1
shift

wide=0 shared=0
for object; do
    [[ $object == *count_avx* ]] || continue
    symbols=$("$nm" --demangle --defined-only "$object")
    grep -q ' T .*::count_at_most_avx' <<<"$symbols" || { echo "$object: no kernel in there"; exit 1; }
    wide=$((wide + 1))
    # clang's own: it ends the program, and computes nothing.
    if grep ' W ' <<<"$symbols" | grep -vE 'Pack[48]|Mask[48]|__clang_call_terminate'; then
        echo "$object: these functions could be shared with other objects"
        shared=1
    fi
done
echo "$wide objects with wide instructions"
exit "$shared"
