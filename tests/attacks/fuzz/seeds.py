"""seeds.py FOLDER: makes the inputs that the fuzz targets begin with, the same ones every time: FOLDER/TARGET/NUMBER.

Targets that read files get true and false certificates, and copies of them with a place changed or an end cut off. Those
that read numbers get spelled ones. Those that take bytes for decisions get any bytes."""

import gzip
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
DECISIONS = {"claims": 160, "leaves": 160, "starts": 160, "piece_store": 1024}
NUMBERS = """1 10 4.61 1e6 9/2 1:100 4:5 1.5e-3:2 5/6 0 00 1/0 -1 +1 .5 5. 1e 1e1001 1e-1001 1/1/1 1:2:3 :2 2: 1,2 0x10
nan inf 3b-2 0b0 5b4096 5b4097 30s 1.5h 90m 2d 0.00001h 999999999999999999 1000000000000000000""".split()
LONGEST_FILE = 4096


def changed(data, draw):
    """One byte changed, or the end cut off, or a line doubled."""
    place = draw.randrange(len(data))
    kind = draw.randrange(3)
    if kind == 0:
        return data[:place] + bytes([draw.randrange(256)]) + data[place + 1:]
    if kind == 1:
        return data[:place]
    lines = data.splitlines(keepends=True)
    line = draw.randrange(len(lines))
    return b"".join(lines[:line + 1] + lines[line:])


def main():
    folder = pathlib.Path(sys.argv[1])
    files = [path.read_bytes() for place in (HERE / "bases", HERE.parent / "false_claims", ROOT / "certificates")
             for path in sorted(place.glob("*.dbc"))]
    files = [data for data in files if 0 < len(data) <= LONGEST_FILE]
    files.append(gzip.decompress((ROOT / "certificates" / "law.dbc.gz").read_bytes())[:LONGEST_FILE])  # its first steps
    draw = random.Random(1)
    seeds = {name: [draw.randbytes(draw.randrange(1, most)) for _ in range(100)] for name, most in DECISIONS.items()}
    seeds["certificate"] = seeds["reader"] = files + [changed(data, draw) for data in files]
    seeds["numbers"] = [text.encode() for text in NUMBERS] + [changed(text.encode(), draw) for text in NUMBERS]
    for target, inputs in seeds.items():
        (folder / target).mkdir(parents=True, exist_ok=True)
        for number, data in enumerate(inputs):
            (folder / target / f"{number:03}").write_bytes(data)


main()
