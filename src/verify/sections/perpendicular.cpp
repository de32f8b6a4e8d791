// The section perpendicular of the scene body (format-sections.md, section 5): bodies with one rho, by the
// upper side of cells.
#include "verify/sections/cell.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::size_t orbits = witness + 1;  // opcode

Box perpendicular_root(std::size_t /*chart*/, const mpq_class& a, const mpq_class& b) {
    return {{0, 0, a}, {0, 0, b}};
}

/// The witness is that of the least Q: greater ones have as many (L83).
const char* check_perpendicular(const Leaf& leaf, Log* log) {
    if (leaf.opcode == orbits)
        return judged<CellRule>(
            Cell{leaf.line, leaf.bits, leaf.multiple, leaf.box, leaf.claimed, 0, 0, 0, leaf.a, leaf.orbits},
            log);
    Leaf least = leaf;
    least.box.hi[2] = least.box.lo[2];
    return body().check(least, log);
}

}  // namespace

const Section& perpendicular() {
    static const Section section = {"body",
                                    "body",
                                    "perpendicular",
                                    "bridge",
                                    {{"", {"", "", "q", "rho"}}},
                                    {{"count", Place::leaf, 0, 0},
                                     {"outside", Place::leaf, 0, 0},
                                     {"meets", Place::leaf, 0, 0},
                                     {"meets-reversed", Place::leaf, 0, 0},
                                     {"equal-masses", Place::cover, 0, 0},
                                     {"witness", Place::witness, 3, 2},
                                     {"orbits", Place::cover, 1, 3}},
                                    perpendicular_root,
                                    check_perpendicular,
                                    false,
                                    "corner",
                                    true};
    return section;
}

}  // namespace dumbbell_verify
