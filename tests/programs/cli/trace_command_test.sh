#!/usr/bin/env bash
# dumbbell trace on the command line: exit codes, one-line messages, output that is whole.
set -u
program=$1
verifier=$2
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

# expect CODE WORD ARGUMENTS...: exit code, and a word of stdout or of the one line on stderr.
expect() {
    local code=$1 word=$2 got
    shift 2
    "$program" trace "$@" > "$scratch/out" 2> "$scratch/err"
    got=$?
    if ((got != code)) || ! cat "$scratch/out" "$scratch/err" | grep -qF -- "$word"; then
        printf 'trace %s: exit %s (expected %s), "%s" expected in:\n' "$*" "$got" "$code" "$word"
        cat "$scratch/out" "$scratch/err"
        ((++failures))
    fi
    if ((code == 2)) && { (($(wc -l < "$scratch/err") != 1)) || [[ -s $scratch/out ]]; }; then
        printf 'trace %s: an error is one line on stderr:\n' "$*"
        cat "$scratch/out" "$scratch/err"
        ((++failures))
    fi
}

start=(10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2)
expect 0 'exactly 1 collision' "${start[@]}"
expect 0 '"outcome": "exact"' "${start[@]}" --json
expect 0 'e-50' "${start[@]}" --digits 50
expect 0 'swapped' 1/10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2
expect 0 'exactly 2 collisions' 10 --phi 0.3:0.31 --phidot -0.01:0.01 --y 3 --ydot -1
expect 0 'the box splits at collision 1' 10 --phi -1:1 --phidot 0 --y 3 --ydot -1
expect 0 'exactly 0 collisions' 10 --phi 1/3 --phidot 1 --y 3 --ydot 1/2
expect 0 'every initial condition in it has 1 collision.' "${start[@]}" --subdivide
expect 3 'cannot be decided at any precision' 10 --phi 0 --phidot 0 --y 3 --ydot -1
expect 3 'at time 3/7 ' 10 --phi -1 --phidot 7/3 --y 3 --ydot -7 --digits 40
expect 3 'the rod falls flat: both masses' 10 --phi pi --phidot 0 --y 3 --ydot -1
expect 3 'the rod falls flat: both masses reach the floor at once (' 2:10 --phi 0 --phidot 0 --y 2:3 --ydot -2:-1
expect 3 '(on or near a flat fall' 10 --phi 1e-30 --phidot 0 --y 3 --ydot -1
expect 3 '(on or near a corner' 10 --phi -1 --phidot 1.0000000000000000000001 --y 1 --ydot -1
expect 3 '"kind": "corner"' 10 --phi -1 --phidot 1 --y 1 --ydot -1 --json
expect 0 'exactly 0 collisions (in every turn a mass grazes' 10 --phi 0 --phidot 1 --y 10/11 --ydot 0
expect 0 'Undecided boxes by what they are on or near to: flat fall' 10 --phi -0.1:0.1 --phidot 0 --y 3 --ydot -1 --subdivide --max-boxes 50
expect 3 'try --digits' 10 --phi 1e-30 --phidot 0 --y 3 --ydot -1
expect 0 'exactly' 10 --phi 1e-30 --phidot 0 --y 3 --ydot -1 --digits 100
expect 0 'Certificate:' 10 --phi 0.3:0.5 --phidot 0 --y 3 --ydot -1 --subdivide --max-boxes 100 --out "$scratch/box.dbc"
expect 0 'exactly 1 collision' 10 --phi -pi/2 --phidot 0 --y 3 --ydot -1
expect 0 '"given": "30deg"' 10 --phi 30deg --phidot 1 --y 3 --ydot -1/2 --json
expect 0 'proved for every phi in' 10 --phi pi/6:60deg --phidot 1/2 --y 3 --ydot -1
expect 3 'cannot be decided' 10 --phi pi --phidot 0 --y 3 --ydot -1
expect 0 '"parts": {' 10 --phi 0.3:0.5 --phidot 0 --y 3 --ydot -1 --subdivide --max-boxes 100 --json

# The file of such a command is verified, with the same bounds.
verified() {
    local words=$1 last
    shift
    "$program" trace "$@" --subdivide --out "$scratch/box.dbc.gz" > "$scratch/out" 2>&1
    last=$("$verifier" "$scratch/box.dbc.gz" | tail -n 1)
    if [[ $last != "s VERIFIED claim=initial-conditions "*"$words"* ]]; then
        printf 'trace %s: "%s" expected in: %s\n' "$*" "$words" "$last"
        ((++failures))
    fi
}
verified 'collisions=1:4 ' 10 --phi 0:3 --phidot -1/2:1/2 --y 3/2 --ydot -1 --max-boxes 3000
verified 'collisions=0:0 decided=1 ' 10 --phi 0.5:0.6 --phidot 0.9:1 --y 2:3 --ydot 1:2
verified 'collisions=2:2 decided=1 ' 10 --phi 1e-30:2e-30 --phidot 0 --y 3 --ydot -1 --digits 60
verified 'collisions=1:90 ' 10000 --phi 4:5 --phidot -0.01:0.01 --y 3 --ydot -0.001 --max-boxes 500
verified 'collisions=1:1 decided=1 ' 10 --phi pi/6:pi/3 --phidot 1/2 --y 3/2 --ydot -1
verified ' ratio=2/1:20/1 ' 2:20 --phi 0.3:0.5 --phidot 0 --y 3/2 --ydot -1 --max-boxes 200

[[ $(head -n 1 "$scratch/box.dbc") == 'dumbbell-certificate 1' ]] || { echo 'no certificate'; ((++failures)); }

expect 2 '--ydot' 10 --phi 1/3 --phidot 1 --y 3
expect 2 '--phi' 10 --phidot 1 --y 3 --ydot -1
expect 2 'RATIO' --phi 1/3 --phidot 1 --y 3 --ydot -1
expect 2 '--phi: the interval' 10 --phi 2:1 --phidot 1 --y 3 --ydot -1
expect 2 '--y: ' 10 --phi 1 --phidot 1 --y high --ydot -1
expect 2 '--y: ' 10 --phi 1 --phidot 1 --y 3: --ydot -1
expect 2 '--phi: ' 10 --phi nan --phidot 1 --y 3 --ydot -1
expect 2 '--phi: ' 10 --phi --1 --phidot 1 --y 3 --ydot -1
expect 2 'like 30deg, pi/2 or 0.3pi' 10 --phi 30degrees --phidot 1 --y 3 --ydot -1
expect 2 'two ways' 10 --phi 1/3pi --phidot 1 --y 3 --ydot -1
expect 2 "'pi/0' divides by zero" 10 --phi pi/0 --phidot 1 --y 3 --ydot -1
expect 2 'is not a multiple of pi' 10 --phi pi/2:pie --phidot 1 --y 3 --ydot -1
expect 2 'is reversed' 10 --phi 2pi:180deg --phidot 1 --y 3 --ydot -1
expect 2 'larger than 1000' 10 --phi 1e9pi --phidot 1 --y 3 --ydot -1
expect 2 '--ydot: ' 10 --phi 1 --phidot 1 --y 3 --ydot 30deg
expect 2 '--phi: too long' 10 --phi 1e-900pi --phidot 1 --y 3 --ydot -1 --digits 3000 --subdivide --out "$scratch/x.dbc"
expect 2 '--y is required' 10 --phi 0 --phidot 1 --ydot -1
expect 2 'resting' 10 --phi 1 --phidot 0 --y 3 --ydot 0
expect 2 'inside the floor' 10 --phi -1 --phidot 0 --y 0.1 --ydot -1
expect 2 'starts on the floor' 10 --phi 0 --phidot 1 --y 0 --ydot 1
expect 2 'part of the box' 10 --phi -0.1:0.1 --phidot 1 --y 0:1 --ydot 1
expect 2 'crosses 1' 0.5:2 --phi 1 --phidot 1 --y 3 --ydot -1
expect 2 '--subdivide' "${start[@]}" --out "$scratch/x.dbc"
expect 2 '--subdivide' "${start[@]}" --shares
expect 0 'all incoming trajectories' 10 --incoming --subdivide --max-boxes 50 --shares
expect 0 'E(-Q rho^2)/pi (L85' --rho 1/2 --inertia 1/2 --incoming --subdivide --max-boxes 50 --shares
expect 0 '"proofs/body.md, L84"' --rho 1/2 --inertia 1/2 --incoming --subdivide --max-boxes 50 --shares --json
expect 2 '--subdivide' 10 --incoming
expect 2 '--phi' 10 --incoming --subdivide --phi 1
expect 2 'single mass ratio' 10:11 --incoming --subdivide
expect 2 '--budget' "${start[@]}" --subdivide --budget 10
expect 2 '--digits' "${start[@]}" --digits 0
expect 2 'no/such' "${start[@]}" --subdivide --out "$scratch/no/such/x.dbc"
((failures == 0)) && echo 'all as expected'
exit $((failures > 0))
