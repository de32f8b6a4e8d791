"""Aligned tables on stdout."""


def ratio(value):
    return "-" if value is None else f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def time(seconds):
    return "-" if seconds is None else f"{seconds:.3f} s"


def memory(megabytes):
    return "-" if megabytes is None else f"{megabytes:.0f} MB"


def rate(value):
    """Something each second."""
    return "-" if value is None else f"{value:,.0f}"


def show(title, head, rows, notes=()):
    """`rows` of strings: the first column is aligned to the left, the others to the right."""
    print(f"\n{title}\n")
    lines = [head, *rows]
    widths = [max(len(line[column]) for line in lines) for column in range(len(head))]
    for number, line in enumerate(lines):
        cells = [cell.ljust(width) if column == 0 else cell.rjust(width) for column, (cell, width) in enumerate(zip(line, widths))]
        print("  " + "  ".join(cells).rstrip())
        if number == 0:
            print("  " + "  ".join("-" * width for width in widths))
    for note in notes:
        print(f"  {note}")
