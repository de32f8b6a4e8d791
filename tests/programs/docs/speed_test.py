#!/usr/bin/env python3
"""What docs/7-speed.md publishes is of the code as it is, and page, picture and data are one thing; the README rounds two of its figures."""
import re
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests/cost/bench"))
from driver import published  # noqa: E402


class Published(unittest.TestCase):
    def test_the_data_are_of_the_code_as_it_is(self):
        if published.digest_of_shipped() != published.digest():
            self.fail(f"docs/pictures/work-precision.tsv is older than the code it measures: {published.COMMAND}")

    def test_the_page_has_the_tables_of_the_data(self):
        page = published.PAGE.read_text()
        self.assertEqual(page.count("<!-- table: "), len(published.TABLES))
        self.assertEqual(published.with_tables(page, published.read()), page)

    def test_the_picture_is_drawn_from_the_data(self):
        self.assertEqual(published.drawn(), published.PICTURE.read_text())

    def test_the_readme_rounds_the_data(self):
        said = re.search(r"from 1 to 10\^6 take (\d+) s of one core together, 10\^100 alone (\d+) s", (published.ROOT / "README.md").read_text())
        cost = {(row["case"], row["setting"]): float(row["cost"]) for row in published.read() if row["method"] == "prove"}
        for words, job in zip(said.groups(), (("certify 1:1000000 --gap", "1e-9"), ("certify", "1e100"))):
            self.assertTrue(2 / 3 < float(words) / cost[job] < 3 / 2, f"README says {words} s, the data {cost[job]}")


if __name__ == "__main__":
    unittest.main()
