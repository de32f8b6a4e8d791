"""What the program is meant to reach, and whether it does in this run. Information: nothing fails here."""
from dataclasses import dataclass


@dataclass
class Goal:
    """At most `goal`, or at least, if `at_least`; `measured` is None where this run or this machine does not measure it."""
    what: str
    goal: float
    measured: float | None
    unit: str = ""
    at_least: bool = False

    @property
    def met(self):
        if self.measured is None:
            return None
        return self.measured >= self.goal if self.at_least else self.measured <= self.goal

    def __str__(self):
        bound = f"goal {'at least' if self.at_least else 'at most'} {self.goal:g}{self.unit}"
        if self.measured is None:
            return f"{self.what}: {bound}, not measured here"
        return f"{self.what}: {bound}, here {self.measured:.3g}{self.unit}: {'met' if self.met else 'NOT MET'}"

    def as_json(self):
        return {"what": self.what, "goal": self.goal, "at_least": self.at_least, "unit": self.unit.strip(),
                "measured": self.measured, "met": self.met}


def show(goals):
    if goals:
        print("\nGoals (information; times depend on the machine and on what else it does)\n")
    for goal in goals:
        print(f"  {goal}")
