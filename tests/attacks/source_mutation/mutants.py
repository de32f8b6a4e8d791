"""Finds mutants of C++ source with libclang, and writes them all into one source.

Every mutant is an expression (or a statement) with another text in its place. All of them are compiled at
once: each expression `E` becomes `(dm::active == 17 ? ALTERNATIVE : E)`, so that one build serves thousands of
mutants, of which the environment variable DUMBBELL_MUTANT chooses one at run time. With DUMBBELL_REACHED, the
name of a file of zero bytes, a run without a mutant marks there which ones it comes by.
"""
import re
from dataclasses import dataclass, field

from clang.cindex import CursorKind as Kind
from clang.cindex import Index

COMPARISONS = {"<": ("<=", ">"), "<=": ("<", ">="), ">": (">=", "<"), ">=": (">", "<="),
               "==": ("!=",), "!=": ("==",)}
SWAPPED_NAMES = {"lo": "hi", "hi": "lo", "first": "second", "second": "first",
                 "down": "up", "up": "down", "min": "max", "max": "min",
                 "low": "high", "high": "low", "sin": "cos", "cos": "sin", "sine": "cosine",
                 "cosine": "sine", "low_end": "high_end", "high_end": "low_end",
                 "r_lo": "r_hi", "r_hi": "r_lo", "kappa": "c", "e0": "e1", "e1": "e0", "y0": "y1",
                 "y1": "y0"}
CHECKS = {"less", "fact", "at_most", "at_least", "misses", "meets", "bridge_meets"}


@dataclass(frozen=True)
class Mutant:
    """`text` in the place of source[start:end]."""
    operator: str
    start: int
    end: int
    text: str
    statement: bool = False
    same_type: bool = False  # an lvalue of the same type: no conversion


@dataclass
class Found:
    mutants: list = field(default_factory=list)
    keys: set = field(default_factory=set)

    def add(self, mutant):
        key = (mutant.start, mutant.end, mutant.text)
        if key not in self.keys and mutant.end > mutant.start:
            self.keys.add(key)
            self.mutants.append(mutant)


def read(path):
    """One character per byte, as libclang counts."""
    with open(path, encoding="latin-1", newline="") as file:
        return file.read()


def find(path, arguments, unit, left_out, with_texts):
    """The mutants of the file `path`, as it is seen in the translation unit `unit`, but for those in functions
    of the names `left_out`. Without texts: but for those in messages, too."""
    source = read(path)
    parsed = Index.create().parse(unit, arguments)
    errors = [d for d in parsed.diagnostics if d.severity >= 3]
    if errors:
        raise SystemExit(f"{unit} does not parse: {errors[0]}")
    found = Found()

    def inside(cursor):
        place = cursor.extent.start
        return place.file is not None and place.file.name == path

    def visit(cursor):
        here = inside(cursor)
        if here and (is_constant(cursor, source) or cursor.spelling in left_out):
            return
        if here and not with_texts and is_message(cursor, source):
            return
        if here:
            for mutant in of(cursor, source):
                found.add(mutant)
        for child in cursor.get_children():
            if child.extent.start.file is None and not here:
                continue
            if not here and child.kind != Kind.NAMESPACE and not inside(child):
                continue
            visit(child)

    for top in parsed.cursor.get_children():
        if inside(top):
            visit(top)
    return sorted(found.mutants, key=lambda m: (m.start, -m.end, m.text))


def is_constant(cursor, source):
    """Places where a run-time choice is no C++: constant expressions and types."""
    text = source[cursor.extent.start.offset:cursor.extent.end.offset]
    if cursor.kind in (Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.TYPEDEF_DECL, Kind.TYPE_ALIAS_DECL,
                       Kind.TEMPLATE_TYPE_PARAMETER, Kind.TEMPLATE_NON_TYPE_PARAMETER):
        return True
    return cursor.kind == Kind.VAR_DECL and re.match(r"(inline |static )*constexpr", text) is not None


def is_message(cursor, source):
    """A text that is put together, or the question whether somebody wants a log."""
    if cursor.kind in (Kind.CALL_EXPR, Kind.BINARY_OPERATOR):
        children = list(cursor.get_children())
        is_sum = cursor.spelling in ("operator+", "operator+=") or (cursor.spelling == "" and len(children) == 2)
        return is_sum and "string" in cursor.type.get_canonical().spelling
    text = source[cursor.extent.start.offset:cursor.extent.end.offset]
    return cursor.kind == Kind.IF_STMT and re.match(r"if \((this->)?log_?\b", text) is not None


def of(cursor, source):
    start, end = cursor.extent.start.offset, cursor.extent.end.offset
    text = source[start:end]
    children = list(cursor.get_children())
    kind = cursor.kind
    if kind in (Kind.BINARY_OPERATOR, Kind.CALL_EXPR) and len(children) >= 2:
        yield from binary(source, start, end, children)
    if kind == Kind.CALL_EXPR:
        callee = re.match(r"(?:[\w:]*(?:::|->|\.))?(\w+)\s*(?:<[^()]*>)?\(", text)
        if callee and callee.group(1) in CHECKS and not text.endswith(", true)"):  # that is for the log
            yield Mutant("ignore a check", start, end, "true")
    if kind == Kind.UNARY_OPERATOR and text[:1] != "" and text[0] in "-!" and len(children) == 1:
        inner = source[children[0].extent.start.offset:children[0].extent.end.offset]
        yield Mutant(f"drop unary {text[0]}", start, end, inner)
    if kind in (Kind.MEMBER_REF_EXPR, Kind.DECL_REF_EXPR):
        # Also of dependent names, whose cursors have no spelling: the text tells.
        name = re.search(r"(\w+)$", text)
        if name and name.group(1) in SWAPPED_NAMES and len(text) < 60:
            other = text[:name.start()] + SWAPPED_NAMES[name.group(1)]
            yield Mutant(f"{name.group(1)} -> {SWAPPED_NAMES[name.group(1)]}", start, end, other,
                         same_type=True)
    if kind == Kind.CALL_EXPR:
        callee = re.match(r"(std::)?(min|max|low_end|high_end)\(", text)
        if callee:
            other = (callee.group(1) or "") + SWAPPED_NAMES[callee.group(2)] + text[callee.end(2):]
            yield Mutant(f"{callee.group(2)} -> {SWAPPED_NAMES[callee.group(2)]}", start, end, other)
    if kind == Kind.INTEGER_LITERAL and re.fullmatch(r"\d+U?L?", text):
        yield Mutant("off by one", start, end, f"({text} + 1)")
        if text[0] != "0":
            yield Mutant("off by one", start, end, f"({text} - 1)")
    if kind == Kind.FLOATING_LITERAL and not re.fullmatch(r"[0.]+", text):
        yield Mutant("drop a pad", start, end, "0.0")
        yield Mutant("weaken a constant", start, end, f"({text} * 0x1p-8)")
    if kind == Kind.IF_STMT and children and children[0].kind != Kind.DECL_STMT:
        first = children[0]
        begin, stop = first.extent.start.offset, first.extent.end.offset
        if not re.match(r"if\s+constexpr", text) and "=" not in source[start:begin]:
            yield Mutant("branch always", begin, stop, "true")
            yield Mutant("branch never", begin, stop, "false")
    if kind == Kind.COMPOUND_STMT:
        for child in children:
            yield from statement(child, source)


def statement(child, source):
    """Leaves a statement out: an expression, `continue`, `break`, or the whole `if (...) return/throw ...`."""
    start, end = child.extent.start.offset, child.extent.end.offset
    text = source[start:end]
    if re.match(r"for \([^;]*;\s*;|while \(true\)", text):
        return  # there is nothing behind it to go on with
    if child.kind in (Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR,
                      Kind.UNEXPOSED_EXPR, Kind.UNARY_OPERATOR, Kind.FOR_STMT, Kind.WHILE_STMT,
                      Kind.CXX_FOR_RANGE_STMT):
        yield Mutant("leave out a statement", start, end, "", statement=True)


def binary(source, start, end, children):
    left, right = children[0], children[-1]
    if len(children) == 3:  # an overloaded operator: left, operator, right
        left, right = children[0], children[2]
    a_end, b_start = left.extent.end.offset, right.extent.start.offset
    if left.extent.start.offset != start or right.extent.end.offset != end or a_end > b_start:
        return
    between = source[a_end:b_start].strip()
    token = between.strip("() \n")
    if between != token:  # parentheses: the operands' extents are not what they seem
        return
    a, b = source[start:a_end], source[b_start:end]
    if token in COMPARISONS:
        for other in COMPARISONS[token]:
            yield Mutant(f"{token} -> {other}", start, end, f"{a} {other} {b}")
    if token in ("&&", "||"):
        yield Mutant(f"drop an operand of {token}", start, end, a)
        yield Mutant(f"drop an operand of {token}", start, end, b)
    if token in ("+", "-"):
        yield Mutant("+ -> -" if token == "+" else "- -> +", start, end, f"{a} {'-' if token == '+' else '+'} {b}")
        yield Mutant("drop a term", start, end, a)
    if token == "*":
        yield Mutant("drop a factor", start, end, a)
        yield Mutant("drop a factor", start, end, b)
    if token == "/":
        yield Mutant("drop a divisor", start, end, a)


HEADER = '''#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>
namespace dm {
struct Chosen {
    long number;
    unsigned char* reached;  // a byte for each mutant, in a file that all processes of a test share
    bool operator==(long other) const {
        if (reached) reached[other] = 1;
        return number == other;
    }
};
inline Chosen chosen() {
    const char* text = std::getenv("DUMBBELL_MUTANT");
    const char* path = std::getenv("DUMBBELL_REACHED");
    Chosen result{text ? std::strtol(text, nullptr, 10) : 0L, nullptr};
    const int file = path ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) return result;
    const off_t size = ::lseek(file, 0, SEEK_END);
    void* bytes = ::mmap(nullptr, static_cast<std::size_t>(size), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (bytes != MAP_FAILED) result.reached = static_cast<unsigned char*>(bytes);
    ::close(file);
    return result;
}
// Set before everything else, tables that are made at start-up too.
__attribute__((init_priority(101))) inline const Chosen active = chosen();
}  // namespace dm
'''


def instrumented(source, numbered):
    """The source with all `numbered` mutants, a list of (number, Mutant), in it."""
    by_extent = {}
    for number, mutant in numbered:
        by_extent.setdefault((mutant.start, mutant.end), []).append((number, mutant))
    extents = sorted(by_extent, key=lambda e: (e[0], -e[1]))

    def render(start, end, inner):
        out, at, i = [], start, 0
        while i < len(inner):
            s, e = inner[i]
            nested = []
            j = i + 1
            while j < len(inner) and inner[j][0] < e:
                if inner[j][1] <= e:
                    nested.append(inner[j])
                j += 1
            out.append(source[at:s])
            out.append(wrap(s, e, nested))
            at, i = e, j
        return "".join(out) + source[at:end]

    def wrap(start, end, nested):
        text, original = render(start, end, nested), source[start:end]
        for number, mutant in by_extent[start, end]:
            if mutant.statement:
                text = f"if (dm::active != {number}) {text}"
            elif mutant.same_type and source[end:].lstrip().startswith("= {"):
                # g++ 12 gives nothing a value in `(condition ? a : b) = {...}`.
                text = f"*(dm::active == {number} ? &{mutant.text} : &{text})"
            elif mutant.same_type:
                text = f"(dm::active == {number} ? {mutant.text} : {text})"
            elif mutant.text in ("true", "false"):
                text = f"(dm::active == {number} ? {mutant.text} : static_cast<bool>({text}))"
            else:
                text = (f"(dm::active == {number} ? static_cast<std::decay_t<decltype({original})>>"
                        f"({mutant.text}) : ({text}))")
        return text

    return render(0, len(source), extents)
