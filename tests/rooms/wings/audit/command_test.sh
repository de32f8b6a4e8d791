#!/bin/bash
# command_test.sh PROGRAM: what `dumbbell audit` prints and returns.
set -uo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# expect CODE PATTERN ARGUMENT...: the command's exit code, and a pattern in its output.
expect() {
    local code=$1 pattern=$2 output actual
    shift 2
    output=$("$program" audit "$@" 2>&1)
    actual=$?
    if [[ $actual != "$code" || ! $output =~ $pattern ]]; then
        printf 'audit %s\n  exit code %s, not %s, or no /%s/ in:\n%s\n' "$*" "$actual" "$code" "$pattern" "$output"
        failures=$((failures + 1))
    fi
}

# head LO HI PIECES: the first lines of a certificate.
head_lines() {
    printf 'dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nlemmas 1\nscene dumbbell\nsection turning\n'
    printf 'claim collisions\nratio %s %s\npieces %s\n' "$1" "$2" "$3"
}

# The lines of standard input, with their checksum.
sealed() {
    tee "$folder/lines"
    printf 'sha256 %s\n' "$(sha256sum < "$folder/lines" | head -c 64)"
}

# piece LO HI: a piece whose chart bridge is split in position.
piece() {
    printf 'piece %s %s\nbits 53\nupper 4\nchart bridge\nsplit e\ncount 1 2\ncount 1 2\nchart light\ncount 1 1\n' "$1" "$2"
    printf 'lower 0\n'
}

{ head_lines 10/1 20/1 2; piece 10/1 15/1; piece 15/1 20/1; } | sealed > "$folder/good.dbc"
gzip -k "$folder/good.dbc"
expect 0 'good.dbc: tiles exactly: 2 pieces, 4 charts, 6 leaves, 2 candidate pairs checked, area exact' "$folder/good.dbc"
expect 0 'good.dbc.gz: tiles exactly' "$folder/good.dbc" "$folder/good.dbc.gz"
expect 0 '"candidate_pairs": 2,' --json "$folder/good.dbc"
expect 0 '"schema": "dumbbell-audit-1"' --json "$folder/good.dbc"
expect 0 'Check by exact geometry' --help

# Pieces that leave a part of the claimed range out.
{ head_lines 10/1 21/1 1; piece 10/1 20/1; } | sealed > "$folder/short.dbc"
expect 3 'the pieces end at ratio 20/1, not at 21/1' "$folder/short.dbc"
expect 3 '"tiles": false' --json "$folder/short.dbc"

# A single ratio that is split: both halves are the same leaf.
{ head_lines 10/1 10/1 1; piece 10/1 10/1 | sed 's/split e/split q/'; } | sealed > "$folder/twice.dbc"
expect 3 'piece 1, chart bridge: leaf 1 .* and leaf 2 .* overlap' "$folder/twice.dbc"
expect 3 'good.dbc: tiles' "$folder/twice.dbc" "$folder/good.dbc"

# A certificate of another kind.
"$program" trace 10 --phi 0.3:0.31 --phidot 0 --y 3 --ydot -1 --subdivide --out "$folder/box.dbc" > "$folder/out"
expect 2 'is about initial conditions .* a certificate with a cover of mass ratios is needed' "$folder/box.dbc"

"$program" trace 10 --incoming --subdivide --max-boxes 20 --out "$folder/in.dbc" > "$folder/out"
expect 2 'is about all incoming trajectories' "$folder/in.dbc"
"$program" adiabatic --delta 0.01 --theorem lemma3.1 --out "$folder/bounce.dbc" > "$folder/out"
expect 2 'is about the adiabatic invariant .* a certificate with a cover of mass ratios is needed' \
    "$folder/bounce.dbc"

# What cannot be read.
expect 2 "no such file" "$folder/none.dbc"
head -c 200 "$folder/good.dbc" > "$folder/cut.dbc"
expect 2 'not a certificate that this program can read' "$folder/cut.dbc"
sed 's/$/\r/' "$folder/good.dbc" > "$folder/foreign.dbc"
expect 2 "foreign.dbc. has line ends of Windows .CR LF.: mend it with tr -d '.r' <OLD >NEW" "$folder/foreign.dbc"
{ printf '\xef\xbb\xbf'; cat "$folder/good.dbc"; } > "$folder/foreign.dbc"
expect 2 'begins with a byte-order mark of UTF-8: mend it with tail -c .4 <OLD >NEW' "$folder/foreign.dbc"
iconv -f ASCII -t UTF-16 "$folder/good.dbc" > "$folder/foreign.dbc"
expect 2 'is UTF-16: mend it with iconv -f UTF-16 -t ASCII <OLD >NEW' "$folder/foreign.dbc"

{ cat "$folder/good.dbc"; printf 'x\n'; } > "$folder/bad.dbc"
expect 2 'bad.dbc. is damaged: its last line is not the checksum of its text' "$folder/bad.dbc"
expect 2 'FILE'

exit $((failures > 0))
