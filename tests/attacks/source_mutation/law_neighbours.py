#!/usr/bin/python3
"""Writes the verifier's law with all of its false neighbours, of which the variable `patches::active` chooses one.

  law_neighbours.py TABLE SOURCE OUT    (tables: law_neighbours.tsv; SOURCE: src/verify/law; OUT: a folder)

A row's place must occur exactly once in its file. OUT/verify/law gets the files, OUT/neighbours.inc the rows.
"""
import collections
import pathlib
import sys


def rows(table):
    lines = table.read_text(encoding="utf-8").splitlines()
    return [(line.split("\t") + [""])[:4] for line in lines if not line.startswith("#")]


def edit(number, source, name, place):
    """(start, end, old text, new text) of one row."""
    before, old, new, after = place.replace("\\n", "\n").split("@")
    context = before + old + after
    if source.count(context) != 1:
        raise SystemExit(f"row {number}: not exactly once in {name}: {place}")
    start = source.index(context) + len(before)
    return start, start + len(old), old, new


def patched(source, edits):
    """The source, with a choice in each place. Places may be the same, but not overlap."""
    places = collections.defaultdict(list)
    for number, (start, end, _, new) in edits:
        places[start, end].append((number, new))
    last = len(source)
    for (start, end), news in sorted(places.items(), reverse=True):
        if end > last:
            raise SystemExit(f"places overlap: {source[start:end]}")
        last, text = start, source[start:end]
        for number, new in news:
            text = f"(patches::active == {number} ? ({new}) : ({text}))"
        source = source[:start] + text + source[end:]
    return "namespace patches { extern int active; }\n" + source


def main():
    table, folder, out = map(pathlib.Path, sys.argv[1:])
    edits, listed = collections.defaultdict(list), []
    for number, (name, cover, place, reason) in enumerate(rows(table), start=1):
        source = (folder / name).read_text(encoding="utf-8")
        edits[name].append((number, edit(number, source, name, place)))
        listed.append(f'{{"{cover}", R"({name}: {place})", R"({reason})"}},\n')
    law = out / "verify" / "law"
    law.mkdir(parents=True, exist_ok=True)
    for path in [*folder.glob("*.hpp"), *(folder / f"{name}.cpp" for name in ("layer", "bulk", "end"))]:
        (law / path.name).write_text(patched(path.read_text(encoding="utf-8"), edits[path.name]), encoding="utf-8")
    (out / "neighbours.inc").write_text("".join(listed), encoding="utf-8")


if __name__ == "__main__":
    main()
