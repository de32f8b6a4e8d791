#include "verify/program/option_table.hpp"

#include "verify/program/claim_options.hpp"
#include "verify/program/help.hpp"
#include "verify/program/version.hpp"

namespace dumbbell_verify {
namespace {

unsigned bits(Arguments& given) { return static_cast<unsigned>(given.number(53, 4096)); }

constexpr Option table[] = {
    {"--ratio", "RATIO|LO:HI", "the mass ratios (heavy/light) in question; default: those of the file"},
    {"--max", "N", "demand the proof that no trajectory has more than N collisions"},
    {"--min", "N", "demand the proof that some trajectory has at least N collisions"},
    {"--exactly", "N", "both"},
    {"--gap", "REL",
     "demand the proof of the greatest number itself, at every ratio in question but in gaps of at most this "
     "relative width, in which it is one of two neighbouring numbers (of bodies: two or three); gaps that "
     "touch are one"},
    {"--gaps", "N", "and that there are at most N of them"},
    {"--heavy-at-most", "1", "demand the proof that the heavy mass hits the floor at most once"},
    {"--inertia", "Q|LO:HI",
     "the bodies in question, rods with mass or the coin: their Q = (d1/k)^2. --max and the others are then "
     "about these bodies, not about a mass ratio"},
    {"--rho", "RHO|LO:HI", "and their d2/d1, above 0 and at most 1"},
    {"--coin", "", "the same as --rho 1 --inertia 4"},
    {"--rod-mass", "MU",
     "with --ratio RATIO: the dumbbell with this mass ratio whose rod has MU times the mass of its ends"},
    {"--scene", "dumbbell|body",
     "demand this scene; default: what the other options state, dumbbell or body, else the file's"},
    {"--claim", "KIND",
     "demand this kind of claim: collisions; initial-conditions (a file of dumbbell trace --subdivide: "
     "--ratio, --max, --min and --exactly are then about the starts in its box); incoming (the same for all "
     "incoming trajectories); adiabatic-bounce, adiabatic-run or adiabatic-scattering (the adiabatic "
     "invariant), or law (all mass ratios)"},
    {"--phi", "A|LO:HI",
     "with --claim initial-conditions: the starts in question, a part of the file's box, in decimals or "
     "fractions such as -1/3:0.5; so --phidot, --y and --ydot. What is demanded of the numbers of collisions "
     "must then follow from the boxes that this part has something in common with"},
    {"--phidot", "A|LO:HI", "the same"},
    {"--y", "A|LO:HI", "the same"},
    {"--ydot", "A|LO:HI", "the same"},
    {"--decided", "SHARE",
     "with --claim initial-conditions or incoming: demand the exact number of collisions for at least this "
     "share of the starts in question, from 0 to 1; of a rectangle of bodies: for this share of those with Q "
     "rho > 1, by area in (log rho, log Q)"},
    {"--delta", "A|LO:HI", "with --claim adiabatic-...: the delta in question, a part of the file's"},
    {"--heights", "A|LO:HI",
     "the heights in question, a part of the file's (adiabatic-bounce, adiabatic-run)"},
    {"--margin", "M", "demand that the claim holds from this margin on, or a smaller one"},
    {"--exponent", "E", "the exponent of the margin's power of delta, such as 1/2 (adiabatic-bounce)"},
    {"--constant", "C|C1,C2", "demand that the constants are at most these (C1,C2: adiabatic-bounce)"},
    {"--attained", "B|B1,B2",
     "demand states, within the delta, heights and margin in question, that attain at least these"},
    {"--claims", "LIST",
     "a list of certificates, each with its claim, such as certificates/claims.tsv. A line has a file (its "
     "name is relative to the list's folder), a tab, and some of the options above: at least --ratio and a "
     "bound (of starts, or --decided), --delta and --constant, or --claim law alone. What follows another "
     "tab is a remark, as is a line that begins with #",
     [](Arguments& given, Asked& to) { to.claims = given.value(); }},
    {"--jobs", "N", "threads (all cores)",
     [](Arguments& given, Asked& to) { to.settings.jobs = static_cast<unsigned>(given.number(1, 1024)); }},
    {"--budget", "TIME",
     "give up on a file that costs more work than a core does in about this time: 30s, 10m, 2h (30s). "
     "Counted in steps, not by a clock: the same on every machine",
     [](Arguments& given, Asked& to) { to.settings.budget = given.time(); }},
    {"--max-bits", "B", "give up on pieces that need a higher precision (2048)",
     [](Arguments& given, Asked& to) { to.settings.max_bits = bits(given); }},
    {"--precision", "BITS", "check with at least this many bits instead of in double",
     [](Arguments& given, Asked& to) { to.settings.precision = bits(given); }},
    {"--explain", "PIECE:PATH",
     "show one leaf with its inequalities: 3:bridge is the root, 3:light.01 the upper half of its lower "
     "half, 3:witness the witness of the third piece; box.01 a leaf of a file about initial conditions or "
     "the adiabatic invariant, in which class0.01 is a leaf of the first class and attained1 the first "
     "attained state; layer.01, bulk1.17 and end.17 boxes of a file about the law",
     [](Arguments& given, Asked& to) { to.settings.explain = given.value(); }, "--json --quiet"},
    {"--shares", "",
     "for one file about initial conditions: how likely each number of collisions is, as bounds of its share "
     "of the box",
     [](Arguments&, Asked& to) { to.settings.shares = true; }, "--quiet --claims"},
    {"--leaves", "",
     "for one file: how many lines of each kind it has, and what share of the root boxes they cover",
     [](Arguments&, Asked& to) { to.options.leaves = true; }, "--json --quiet --claims"},
    {"--json", "", "print JSON and nothing else: an array of one object for each file",
     [](Arguments&, Asked& to) { to.options.json = true; }},
    {"--quiet", "", "print the last line only (or JSON), and show no progress",
     [](Arguments&, Asked& to) { to.options.quiet = true; }},
    {"-h, --help", "", "print this help and end", [](Arguments&, Asked& to) { to.options.answer = help(); }},
    {"--man", "", "print the manual page and end",
     [](Arguments&, Asked& to) { to.options.answer = man_page(); }},
    {"-V, --version", "", "print the version, the compiler and its flags, and end",
     [](Arguments&, Asked& to) { to.options.answer = "dumbbell-verify " + std::string(version) + "\n"; }},
};

}  // namespace

std::span<const Option> option_table() { return table; }

}  // namespace dumbbell_verify
