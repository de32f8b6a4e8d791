#!/usr/bin/env python3
"""links_test.py [FOLDER]: every link in a Markdown page to a file of this project, or to a heading in one, leads somewhere;
every page of docs/ and proofs/ is in the table of contents, docs/README.md. Of FOLDER, if its pages are others."""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[3]


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


def anchors(page):
    """The names that a page's headings get (as on GitHub)."""
    names = set()
    for heading in re.findall(r"^#+ (.*)$", page.read_text(), re.M):
        name = re.sub(r"[^\w\- ]", "", re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading).lower()).replace(" ", "-")
        names.add(name if name not in names else name + "-1")
    return names


def broken(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(page.read_text())):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        path = (page.parent / name) if name else page
        if not path.exists():
            yield f"{target}: no such file"
        elif anchor and path.suffix == ".md" and anchor not in anchors(path):
            yield f"{target}: no such heading"


def pages():
    """All but those of others: npm's, and what lies in build folders."""
    return [page for page in sorted(ROOT.rglob("*.md"))
            if not any(part.startswith((".", "build")) or part == "node_modules" for part in page.relative_to(ROOT).parts)]


def missing_in_contents():
    contents = ROOT / "docs" / "README.md"
    linked = {(contents.parent / target.partition("#")[0]).resolve()
              for target in re.findall(r"\]\(([^)\s]+)\)", contents.read_text())}
    for folder in ("docs", "proofs"):
        for page in sorted((ROOT / folder).rglob("*.md")):
            if page != contents and page.resolve() not in linked:
                yield page.relative_to(ROOT)


def main():
    failures = [f"{page.relative_to(ROOT)}: {what}" for page in pages() for what in broken(page)]
    failures += [f"docs/README.md does not link {page}" for page in missing_in_contents()]
    print("\n".join(failures) or f"{len(pages())} pages: all links lead somewhere")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
