"""rooms_test.py: src/README.md says which room may use which; the includes say the same, every file opens its room's
namespace and no other, and no two types of one name meet in a program. The mission stands
before its wings there, and the files that its two ways name can be read at one sitting. No function takes a claim in parts. Of the tests one header alone knows Catch2, which
is of version 2 or 3."""

import collections
import pathlib
import re
import sys

SRC = pathlib.Path(__file__).resolve().parents[3] / "src"
TESTS = SRC.parent / "tests"
ROW = re.compile(r"\| `([a-z_/]+)` \| [^|]+ \| ([^|]*)\|")
GROUND = re.compile(r"The ground \(([^)]*)\) is `namespace dumbbell`")
WAYS = re.compile(r"## The way of one ratio(.*)## The rooms(.*)## The wings", re.S)
MOST_LINES = 6000
INCLUDE = re.compile(r'^#include "([a-z_/0-9]+\.hpp)"', re.M)
# A parameter that is a part of a claim (collisions/claim.hpp): a section or a scene.
LOOSE = re.compile(r"[(,]\s*(?:const )?(?:[\w:]+::)?(?:(?:Section|Scene)&? \w+|[\w:<>]+&? (?:scene|section))\s*[,)]")
MAY_BE_LOOSE = re.compile(r"collisions/(?:claim|section|sections/\w+)\.|python/certify\.cpp")  # the latter: keywords
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
TOKEN = re.compile(
    r"namespace(?P<space>(?:\s+[\w:]+)?)\s*\{"
    r"|(?:template\s*<[^;{}]*>\s*)?\b(?:struct|class|enum(?:\s+class|\s+struct)?)\s+(?P<type>\w+)(?:\s+final)?\s*(?::[^;{}()]*)?\{"
    r"|[{}]")


def table():
    """Room -> the rooms that it may use, in the table's order."""
    rows = ROW.findall((SRC / "README.md").read_text(encoding="utf-8"))
    return {room: re.findall(r"`([a-z_/]+)`", used) for room, used in rows}


def room_of(path, rooms):
    """The longest name of a room that the path lies in."""
    inside = [room for room in rooms if path.startswith(room + "/")]
    return max(inside, key=len, default=None)


def namespace_of(room, ground):
    """The namespace that the room's files open."""
    if room.startswith("verify/"):
        return "dumbbell_verify"
    if room == "commands":
        return "dumbbell::cli"
    return "::".join(["dumbbell"] if room in ground else ["dumbbell", *room.split("/")])


def opened(text):
    """The namespaces of this project that a file opens: those that no brace surrounds."""
    depth = 0
    for token in TOKEN.finditer(NOISE.sub(" ", text)):
        if depth == 0 and (token["space"] or "").strip().startswith("dumbbell"):
            yield token["space"].strip()
        depth += -1 if token[0] == "}" else 1


def types(text):
    """The types that a file defines at the level of a namespace with a name."""
    spaces = []  # of every open brace: the namespace's name, "" without a name, None if it is none
    for token in TOKEN.finditer(NOISE.sub(" ", text)):
        if token[0] == "}":
            if spaces:
                spaces.pop()
        elif token["space"] is not None:
            spaces.append(token["space"].strip())
        else:
            if token["type"] and all(spaces):
                yield "::".join([*spaces, token["type"]])
            spaces.append(None)


def lines_of_ways():
    """Of all files of the mission that have a name which the ways give; of a wing's, where the mission has none."""
    ways, mission = WAYS.search((SRC / "README.md").read_text(encoding="utf-8")).groups()
    inside = [room for room, _ in ROW.findall(mission)]
    total = 0
    for name in sorted(set(re.findall(r"`([a-z_/]+\.[ch]pp)`", ways))):
        files = [file for file in SRC.rglob("*.?pp") if file.as_posix().endswith("/" + name)]
        named = [file for file in files if room_of(file.relative_to(SRC).as_posix(), table()) in inside] or files
        total += sum(len(file.read_text(encoding="utf-8").splitlines()) for file in named)
        if not named:
            raise SystemExit(f"src/README.md names {name}: there is no such file")
    return total


def main():
    allowed, used, faults = table(), collections.defaultdict(set), []
    order = list(allowed)
    ground = re.findall(r"`([a-z_/]+)`", GROUND.search((SRC / "README.md").read_text(encoding="utf-8"))[1])
    spaces = {room: namespace_of(room, ground) for room in order}
    defined = collections.defaultdict(set)
    for file in sorted(SRC.rglob("*.?pp")):
        path = file.relative_to(SRC).as_posix().removeprefix("wings/")
        room, text = room_of(path, order), file.read_text(encoding="utf-8")
        if room is None:
            faults.append(f"{path} is in no room of src/README.md")
            continue
        for space in opened(text):
            owners = [owner for owner in spaces.values() if space == owner or space.startswith(owner + "::")]
            if max(owners, key=len, default=None) != spaces[room]:
                faults.append(f"{path} opens namespace {space}: the room's is {spaces[room]}")
        if room in ("collisions", "cli", "commands", "api", "page", "python") and not MAY_BE_LOOSE.match(path):
            faults += [f"{path} takes a part of a claim loose: {found}" for found in LOOSE.findall(NOISE.sub(" ", text))]
        for name in types(text):
            defined[name].add(path)
        for include in INCLUDE.findall(text):
            other = room_of(include, order)
            if other is None or other == room:
                continue
            used[room].add(other)
            if other not in allowed[room]:
                faults.append(f"{path} includes {include}: {room} may not use {other}")
            if order.index(other) > order.index(room):
                faults.append(f"{path} includes {include}: {other} stands on {room} or next to it")
    for room, rooms in allowed.items():
        faults += [f"{room} does not use {other}" for other in rooms if other not in used[room]]
    faults += [f"{name} is defined in {' and '.join(sorted(files))}" for name, files in defined.items() if len(files) > 1]
    faults += [f"{file.relative_to(SRC.parent)} uses Catch2 past tests/catch.hpp" for file in sorted(TESTS.rglob("*.?pp"))
               if file != TESTS / "catch.hpp" and re.search("catch2/|Catch::", file.read_text(encoding="utf-8"))]
    lines = lines_of_ways()
    faults += [f"the ways of src/README.md name files of {lines:,} lines: at most {MOST_LINES:,}"] if lines > MOST_LINES else []
    for fault in faults:
        print(fault)
    print(f"{len(order)} rooms, {len(defined)} types, {lines:,} lines to read, {len(faults)} faults")
    return 1 if faults or not order else 0


sys.exit(main())
