#!/usr/bin/env python3
"""citation_test.py VERSION: CITATION.cff, CITATION.bib and CHANGELOG.md speak of this version of the program, the former two alike."""

import pathlib
import re
import sys

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]


def main():
    version = sys.argv[1]
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert citation["cff-version"] == "1.2.0"
    assert str(citation["version"]) == version, f"CITATION.cff says {citation['version']}, the project {version}"
    for entry in [citation, *citation["references"]]:  # what the format requires
        assert entry["title"] and entry["authors"]
    assert citation["message"]
    assert all(reference["type"] for reference in citation["references"])
    bib = (ROOT / "CITATION.bib").read_text()
    assert re.findall(r"version += \{(.*?)\}", bib) == [version], "CITATION.bib gives another version"
    assert re.findall(r" title += \{(.*?)\}", bib) == [entry["title"] for entry in [citation, *citation["references"]]]
    assert f"## [{version}]" in (ROOT / "CHANGELOG.md").read_text(), f"CHANGELOG.md has no entry {version}"


if __name__ == "__main__":
    main()
