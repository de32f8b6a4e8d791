"""Programs on the workers' hosts in place of the real one: shell scripts that take `campaign work ... ORDER RESULT`."""


def slow(program: str, seconds: float) -> str:
    """The real one, after a while: its shards take milliseconds, and the faults need time to happen."""
    return f'#!/bin/sh\nsleep {seconds}\nexec {program} "$@"\n'


RESEAL = """
seal() {
    head -n -1 "$1" > body
    printf 'sha256 %s\\n' "$(sha256sum < body | cut -c 1-64)" | cat body - > "$1"
}
"""


def of_version(program: str, version: str) -> str:
    """The real one, to which the order seems to come from a dumbbell of this version: as if it were another one."""
    return "#!/bin/sh\n" + RESEAL + f"""
cp order other && sed -i 's/^generator dumbbell .*/generator dumbbell {version}/' other && seal other
exec {program} campaign work other result
"""


def garbled(program: str, how: str) -> str:
    """The real one, and then something happens to its result: a file of this name."""
    return "#!/bin/sh\n" + RESEAL + f'{program} "$@" || exit\n{how}\n'


# Of each piece nothing is said, with the right totals: a true certificate that proves nothing.
UNDECIDED = """awk '
    /^(total|sha256) / {next}
    /^piece / {n++; print; print "bits 53\\nupper none\\nlower 0"}
    !n {print}
    END {
        last = split("split count outside meets meets-reversed equal-masses witness", words)
        for (i = 1; i <= last; i++) print "total " words[i] " 0"
        print "total open " n; print "sha256"
    }' result > edited; mv edited result; seal result"""


def garblers(program: str) -> dict[str, str]:
    """What may happen to a result."""
    other = f"{program} certify 3:4 --gap 1e-9 --quiet --out other.dbc; mv other.dbc result"
    edited = "awk '/^{0} / && !n++ {{{1}}} {{print}}' result > edited; mv edited result; seal result"
    return {
        "random": garbled(program, "head -c 3000 /dev/urandom > result"),
        "empty": garbled(program, ": > result"),
        "truncated": garbled(program, "head -n 30 result > half; mv half result"),
        "elsewhere": garbled(program, other),
        # With a right checksum: the bound of a piece is one less; the count in a leaf is, and no bound changes.
        "bound": garbled(program, edited.format("upper", "$2 -= 1")),
        "leaf": garbled(program, edited.format("count", "$2 = 1; $3 = 1")),
        "undecided": garbled(program, UNDECIDED),
    }


def noted(program: str, folder: str) -> str:
    """The real one, which keeps a copy of each order as it begins, and waits as long as there is a file `FOLDER-held`."""
    return f'#!/bin/sh\nmkdir -p {folder}\ncp order {folder}/$$.tmp && mv {folder}/$$.tmp {folder}/$$\n' \
           f'while test -e {folder}-held; do sleep 0.1; done\nexec {program} "$@"\n'
