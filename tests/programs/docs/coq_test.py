#!/usr/bin/env python3
"""coq_test.py: what the pages say of the Coq proof is there: each theorem that proofs/table.md and proofs/coq/README.md
name stands in the file they name, the lines that the README quotes stand in the statement, and a file that others
import has a table `name == meaning` at its head, of names that stand in it."""

import pathlib
import re
import sys

PROOFS = pathlib.Path(__file__).resolve().parents[3] / "proofs"
KINDS = "Theorem|Lemma|Corollary|Definition|Fixpoint|Record|Inductive|Let|Notation"
STATED = re.compile(r"^\s*(?:Theorem|Lemma|Corollary)\s+([\w']+)", re.M)


def rows(page):
    """The cells of each row of the page's tables, with the name of each column."""
    columns = []
    for line in page.read_text().splitlines():
        if not line.startswith("|"):
            columns = []
            continue
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not columns:
            columns = cells
        elif not set(line) <= set("|-: "):
            yield dict(zip(columns, cells)) if len(cells) == len(columns) else {"": line}


def named(page, column):
    """The theorems that a column names; a row that lacks the column, or has nothing there, is a fault."""
    found = []
    for row in rows(page):
        if column in row:
            names = re.findall(r"`(\w+)\.([\w']+)`", row[column])
            if not names and row[column] != "-":
                yield None, f"{page.name}: neither theorem nor '-': {row[column]}"
            found += names
        elif "" in row:
            yield None, f"{page.name}: a row has too many or too few columns: {row[''][:60]}"
    yield from ((name, None) for name in found)
    if not found:
        yield None, f"{page.name}: names no theorem"


def tables(texts):
    """The faults of the tables at the heads of the files; texts: what each says."""
    imported = set(re.findall(r"\w+", " ".join(re.findall(r"From Dumbbell Require (?:Import|Export) ([^.]*)", " ".join(texts.values())))))
    for file, text in texts.items():
        head = re.match(r"\(\*\*.*?\*\)", text, re.S)[0]
        names = re.findall(r"^    (\w[\w', ]*?)\s*==", head, re.M)
        if file in imported and not names:
            yield f"{file}.v: others import it, and it has no table `name == meaning`"
        for name in (word.split()[0] for row in names for word in row.split(",")):
            if not re.search(rf"(?:{KINDS}|Ltac|[{{;|]|:=)\s+{name}(?![\w'])", text[len(head):]):
                yield f"{file}.v: the table at its head names {name}, which it does not have"


def main():
    stated, texts = {}, {file.stem: file.read_text() for file in (PROOFS / "coq").rglob("*.v")}
    for file in (PROOFS / "coq").rglob("*.v"):
        stated.setdefault(file.stem, set()).update(STATED.findall(file.read_text()))
    faults, theorems = list(tables(texts)), set()
    for page, column in ((PROOFS / "table.md", "Coq"), (PROOFS / "coq" / "README.md", "theorem")):
        for name, fault in named(page, column):
            if fault:
                faults.append(fault)
            elif name[1] not in stated.get(name[0], ()):
                faults.append(f"{page.name}: no theorem {name[1]} in {name[0]}.v")
            else:
                theorems.add(name)
    statement = (PROOFS / "coq" / "statement" / "Statement.v").read_text()
    lines = {re.sub(r"\s*\(\*.*\*\)$", "", line) for line in statement.splitlines()}
    quoted = [line for block in re.findall(r"^```coq\n(.*?)^```", (PROOFS / "coq" / "README.md").read_text(), re.M | re.S)
              for line in block.splitlines()]
    faults += [f"README.md quotes what Statement.v does not say: {line}" for line in quoted if line not in lines]
    if not quoted:
        faults.append("README.md quotes no line of the statement")
    print("\n".join(faults) or f"{len(theorems)} theorems and {len(quoted)} lines of the statement are in proofs/coq")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
