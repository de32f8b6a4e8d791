// What the grammar of a certificate and the mathematics of a section know of each other.
#pragma once
#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dumbbell_verify {

/// An exact box; the last axis is the mass ratio q = heavy / light >= 1.
struct Box {
    std::array<mpq_class, 3> lo, hi;
};

/// One thing to check: a leaf of a tree, a cover of one line, or a witness (the box: one point times [A, B]).
struct Leaf {
    std::size_t chart = 0, opcode = 0;
    std::uint64_t a = 0, b = 0, claimed = 0, line = 0;  ///< two hints; U of the piece, for a witness V
    unsigned bits = 53;                                 ///< working precision; 53 is double unless `multiple`
    bool multiple = false;
    Box box;
};

enum class Place { leaf, cover, witness };

struct Opcode {
    std::string_view name;
    Place place;
    unsigned charts, hints;  ///< bit set of the charts that it occurs in; number of its hints (0 or 2)
};
struct Chart {
    std::string_view name;
    std::array<std::string_view, 3> axes;
};

/// A section of one scene, with its opcodes in the order of the trailer. `check` returns nullptr if
/// everything that format.md demands of the leaf is certified, else what is not; a log gets a line for every
/// inequality.
struct Section {
    std::string_view scene, name;
    std::vector<Chart> charts;
    std::vector<Opcode> opcodes;
    Box (*root)(const mpq_class& a, const mpq_class& b);
    const char* (*check)(const Leaf& leaf, std::string* log);
};

const Section& turning();

}  // namespace dumbbell_verify
