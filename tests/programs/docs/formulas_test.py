#!/usr/bin/env python3
"""formulas_test.py: the formulas of docs/ and proofs/, $...$ and $$...$$, are written so that both GitHub and pandoc show them.

GitHub reads Markdown first: a backslash before a sign is lost, and * or _ may begin emphasis, an index only if no letter or
digit stands before it. pandoc takes no formula that begins or ends with a space, or is followed by a digit.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
CODE = re.compile(r"^```.*?^```$|^ {4}[^\n]*$|`[^`\n]*`", re.M | re.S)
DISPLAY = re.compile(r"\$\$(.+?)\$\$", re.S)
INLINE = re.compile(r"(.?)\$([^$\n]*)\$(.?)")
LOST = re.compile(r"\\[^A-Za-z\s]|(?<![A-Za-z0-9])_|\*|\]\(|<[A-Za-z/!]")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def faults(text):
    text = CODE.sub(blank, text)
    for formula in DISPLAY.findall(text):
        yield from (f"{found.group()} in {formula.strip()}" for found in LOST.finditer(formula))
    text = DISPLAY.sub(blank, text)
    for before, formula, after in INLINE.findall(text):
        yield from (f"{found.group()} in {formula}" for found in LOST.finditer(formula))
        if not formula or formula != formula.strip() or before.isalnum() or after.isalnum():
            yield f"a formula needs signs or spaces around it, and no spaces inside: {before}${formula}${after}"
        if formula.count("{") != formula.count("}"):
            yield f"braces in {formula}"
    yield from (f"a dollar alone: {line.strip()}" for line in INLINE.sub("", text).splitlines() if "$" in line)


def main():
    pages = [page for folder in ("docs", "proofs") for page in sorted((ROOT / folder).rglob("*.md"))]
    found = [f"{page.relative_to(ROOT)}: {fault}" for page in pages for fault in faults(page.read_text(encoding="utf-8"))]
    print("\n".join(found) or f"{len(pages)} pages: both GitHub and pandoc show their formulas")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
