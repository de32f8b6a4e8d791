"""What was injected and what came of it: one line of the table per fault."""

from dataclasses import dataclass, field


@dataclass
class Tally:
    fault: str
    injected: int = 0
    lost: int = 0  # results that were finished and are gone
    half_written: int = 0  # files under their final name that are not whole
    wrong_codes: int = 0
    skipped: str = ""
    complaints: list[str] = field(default_factory=list)

    def complain(self, kind: str, text: str) -> None:
        """`kind`: the counter that goes up."""
        setattr(self, kind, getattr(self, kind) + 1)
        self.complaints.append(f"{self.fault}: {kind}: {text}")

    def expect_code(self, outcome, allowed, doing: str) -> None:
        if outcome.code not in allowed:
            self.complain("wrong_codes", f"{doing}: {outcome.code} instead of {allowed}; it said {outcome.err[-300:]!r}")

    @property
    def passed(self) -> bool:
        return not (self.lost or self.half_written or self.wrong_codes)


def table(tallies: list[Tally]) -> str:
    heads = ("fault", "injected", "lost results", "half-written files", "wrong exit codes")
    rows = [(t.fault, f"skipped: {t.skipped}", "", "", "") if t.skipped else
            (t.fault, str(t.injected), str(t.lost), str(t.half_written), str(t.wrong_codes)) for t in tallies]
    first = max(len(row[0]) for row in (heads, *rows))
    return "\n".join(row[0].ljust(first) + "".join("  " + cell.rjust(len(head)) for cell, head in zip(row[1:], heads[1:]))
                     for row in (heads, *rows))
