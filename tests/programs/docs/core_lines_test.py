"""core_lines_test.py: the trusted core of the main claim has as many lines as docs/4-verifying.md says."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]


def main():
    files = [file for room in ("number", "format", "collisions") for file in (ROOT / "src/verify" / room).iterdir()]
    lines = sum(file.read_text(encoding="utf-8").count("\n") for file in files)
    said = f"are {lines:,} lines" in (ROOT / "docs/4-verifying.md").read_text(encoding="utf-8")
    print(f"{lines:,} lines in {len(files)} files" + ("" if said else ", and docs/4-verifying.md does not say so"))
    return 0 if said and lines > 0 else 1


sys.exit(main())
