#!/usr/bin/env python3
"""pack.py FILE: packs the verifier of this folder into one file that Python runs. The same sources give the same bytes, where
zlib is the same."""

import os
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEAD = b"#!/usr/bin/env python3\n"


def entries():
    """The names in the archive, and their files: the modules, and the licence."""
    modules = {path.name: path for path in HERE.glob("*.py") if path.name != Path(__file__).name}
    return sorted({**modules, "LICENSE": HERE.parents[2] / "LICENSE"}.items())


def pack(target):
    """Writes the file, all of it or nothing."""
    target.parent.mkdir(parents=True, exist_ok=True)
    unfinished = target.with_name(target.name + ".unfinished")
    with open(unfinished, "wb") as file:
        file.write(HEAD)
        with zipfile.ZipFile(file, "w") as archive:
            for name, path in entries():
                entry = zipfile.ZipInfo(name)  # of 1 January 1980
                entry.create_system, entry.external_attr = 3, 0o644 << 16
                archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)
    unfinished.chmod(0o755)
    os.replace(unfinished, target)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    pack(Path(sys.argv[1]))
