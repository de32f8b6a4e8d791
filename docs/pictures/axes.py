"""What law-picture and scattering-picture share: the program, the page and its frames. Lengths are pixels, y downwards."""
import json
import math
import os
import pathlib
import subprocess
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH, RIGHT = 860, 828
STYLE = """text{font:13px sans-serif;fill:#222}.head{font-weight:600;font-size:15px}.small{font-size:12px;fill:#59626c}
.page{fill:#fff}.grid{stroke:#e2e5e9}.frame{fill:none;stroke:#8b949e}"""
DARK = "text{fill:#d9dee4}.small{fill:#9aa4af}.page{fill:#12161c}.grid{stroke:#2a313a}.frame{stroke:#6c7680}"


def printed(*words):
    """What the program prints; DUMBBELL names it."""
    program = os.environ.get("DUMBBELL", str(ROOT / "run")).split()
    return json.loads(subprocess.run([*program, *words, "--json"], stdout=subprocess.PIPE, text=True, check=True).stdout)


def px(length):
    return f"{round(length, 2):g}"


def line(points):
    return "M" + "L".join(f"{px(x)} {px(y)}" for x, y in points)


def path(kind, data):
    return f'<path class="{kind}" d="{data}"/>'


def text(x, y, words, anchor="start", kind=""):
    return f'<text class="{kind}" x="{px(x)}" y="{px(y)}" text-anchor="{anchor}">{words}</text>'


def caption(x, y, words):
    return [text(x, y + 17 * i, row, kind="small") for i, row in enumerate(textwrap.wrap(words, 115))]


def legend(x, y, kind, words, is_area=False):
    return path(kind, f"M{x} {y - 10}h26v12h-26z" if is_area else f"M{x} {y - 4}h26") + text(x + 33, y, words)


def even_ticks(low, high, most):
    """Marks at round numbers."""
    unit = 10 ** math.floor(math.log10((high - low) / most))
    step = next(unit * times for times in (1, 2, 5, 10) if high - low <= unit * times * most)
    return {step * i: f"{step * i:.6g}".replace("-", "−") for i in range(math.ceil(low / step), math.floor(high / step) + 1)}


class Frame:
    """A rectangle of the page with axes; each is (low, high, name, marks)."""

    def __init__(self, left, top, height, across, up, is_logarithmic=False):
        self.left, self.top, self.height, self.across, self.up = left, top, height, across, up
        self.scale = math.log if is_logarithmic else float
        self.bottom = top + height

    def x(self, value):
        low, high = map(self.scale, self.across[:2])
        return self.left + (RIGHT - self.left) * (self.scale(value) - low) / (high - low)

    def y(self, value):
        low, high = self.up[:2]
        return self.bottom - self.height * (value - low) / (high - low)

    def drawn(self, behind, before):
        """Shapes behind the grid and before it, cut to the frame, and the axes."""
        clip = f"clip{px(self.top)}"
        size = f'x="{self.left}" y="{px(self.top)}" width="{RIGHT - self.left}" height="{self.height}"'
        yield f'<clipPath id="{clip}"><rect {size}/></clipPath><g clip-path="url(#{clip})">'
        yield from behind
        yield path("grid", "".join(f"M{px(self.x(at))} {px(self.top)}v{self.height}" for at in self.across[3]))
        yield path("grid", "".join(f"M{self.left} {px(self.y(at))}H{RIGHT}" for at in self.up[3]))
        yield from before
        yield f'</g><rect class="frame" {size}/>'
        yield from (text(self.x(at), self.bottom + 19, label, "middle") for at, label in self.across[3].items())
        yield from (text(self.left - 8, self.y(at) + 4.5, label, "end") for at, label in self.up[3].items())
        yield text((self.left + RIGHT) / 2, self.bottom + 40, self.across[2], "middle")
        yield f'<g transform="translate({self.left - 42} {px(self.top + self.height / 2)}) rotate(-90)">{text(0, 0, self.up[2], "middle")}</g>'


def page(title, height, colours, rules, shapes):
    """`colours`: {class: (fill or stroke, its colour on light pages, on dark ones)}; `rules`: more CSS."""
    light, dark = ("".join(f".{kind}{{{what[0]}:{what[i]}}}" for kind, what in colours.items()) for i in (1, 2))
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" role="img">',
                      f"<title>{title}</title>",
                      f"<style>{STYLE}{rules}{light}@media (prefers-color-scheme:dark){{{DARK}{dark}}}</style>",
                      f'<rect class="page" width="{WIDTH}" height="{height}"/>', *shapes, "</svg>"])
