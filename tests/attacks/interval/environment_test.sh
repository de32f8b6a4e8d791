#!/usr/bin/env bash
# environment_test.sh DUMBBELL VERIFIER CERTIFICATES FORCE FAST_MATH: both programs are right where something else in the
# process spoils the arithmetic, or no more threads may start. FORCE and FAST_MATH are libraries to preload (environment/).
# From DUMBBELL_TEST_SCALE=20 on every command is tried in every setting, otherwise every seventh and in the settings of a
# register that change most.
set -uo pipefail
dumbbell=$1 verifier=$2 certificates=$3 force=$4 fast_math=$5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
scale=${DUMBBELL_TEST_SCALE-1}
number=0
declare -A count

fail() {
    printf 'FAILED %s\n' "$*"
    failures=$((failures + 1))
}

# Each word of the program, and the verifier: alone on a small certificate, and with leaves enough for 8 threads.
stairs=$certificates/stairs-1-100.dbc
words=(certify far critical law audit trace starts adiabatic plot verify leaves full ones)
command_of() {
    case $1 in
        certify) command=("$dumbbell" certify 1:30 --gap 1e-6 --jobs 8 --out "$folder/out.dbc") ;;
        far) command=("$dumbbell" certify 1e18 --jobs 8 --out "$folder/out.dbc") ;;
        critical) command=("$dumbbell" critical 3:12 --jobs 8) ;;
        law) command=("$dumbbell" law --count 1e50) ;;
        audit) command=("$dumbbell" audit "$stairs") ;;
        trace) command=("$dumbbell" trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2) ;;
        starts) command=("$dumbbell" trace 10 --phi 0.3:0.4 --phidot 1 --y 3 --ydot -1/2 --subdivide --max-boxes 500 --jobs 8) ;;
        adiabatic) command=("$dumbbell" adiabatic --delta 0.01 --theorem lemma3.1 --jobs 8) ;;
        plot) command=("$dumbbell" plot staircase "$stairs" --out "$folder/out.svg") ;;
        verify) command=("$verifier" "$certificates/q-10.dbc") ;;
        leaves) command=("$verifier" --jobs 8 "$stairs") ;;
        full) command=("$verifier" --jobs 8 "$certificates/full-100.dbc.gz") ;;
        ones) command=("$verifier" "$certificates/q-1.dbc") ;;
    esac
}

written() { compgen -G "$folder/out.*" > /dev/null; }

# run VARIABLE=VALUE...: the command in such an environment; sets code and output, without what differs from run to run.
run() {
    rm -rf "$folder"/out*
    output=$(env "$@" "${command[@]}" 2>&1)
    code=$?
    output=$(sed -E 's/[0-9.]+ (ms|s)\b//g; s/ +/ /g' <<< "$output")
    ! written || output+=" sha256 $(cat "$folder"/out.* | sha256sum)"
}

# same WHAT VARIABLE=VALUE...: the commands that are tried print what it prints otherwise.
same() {
    local what=$1 word
    shift
    number=$((number + 1)) # so that each setting begins with another command
    for word in "${words[@]}"; do
        number=$((number + 1))
        ((scale >= 20 || number % 7 == 0)) || continue
        command_of "$word"
        run "$@"
        if [[ $output == "${usual[$word]}" ]]; then
            count[$word]=$((${count[$word]-0} + 1))
        else
            fail "$what, $word: exit code $code, another result:"
            diff <(echo "${usual[$word]}") <(echo "$output")
        fi
    done
}

declare -A usual
for word in "${words[@]}"; do
    command_of "$word"
    run LD_PRELOAD="$force" # changes nothing unless told to
    [[ $code == 0 ]] || fail "$word fails without any force: exit code $code"$'\n'"$output"
    usual[$word]=$output
done

sse=(8040 6000) x87=(c00) traps=(3d)
((scale < 20)) || sse+=(2000 4000) x87+=(400) traps+=(1)
in_main=(LD_PRELOAD="$force" DUMBBELL_FORCE_IN=main) in_threads=(LD_PRELOAD="$force" DUMBBELL_FORCE_IN=threads)
for bits in "${sse[@]}"; do
    same "MXCSR $bits" "${in_main[@]}" DUMBBELL_FORCE_SSE=$bits
    same "MXCSR $bits in threads" "${in_threads[@]}" DUMBBELL_FORCE_SSE=$bits
done
same 'a library built with -ffast-math' LD_PRELOAD="$fast_math"
for bits in "${x87[@]}"; do
    same "x87 $bits" "${in_main[@]}" DUMBBELL_FORCE_X87=$bits
    same "x87 $bits in threads" "${in_threads[@]}" DUMBBELL_FORCE_X87=$bits
done
for bits in "${traps[@]}"; do
    same "traps $bits" "${in_main[@]}" DUMBBELL_FORCE_TRAPS=$bits
    same "traps $bits in threads" "${in_threads[@]}" DUMBBELL_FORCE_TRAPS=$bits
done
for threads in 0 3; do
    same "no more than $threads threads" LD_PRELOAD="$force" DUMBBELL_FORCE_THREADS=$threads
done

for word in "${words[@]}"; do
    printf '%-10s %s times the same result\n' "$word" "${count[$word]-0}"
done
printf 'failures: %d\n' "$failures"
exit $((failures > 0))
