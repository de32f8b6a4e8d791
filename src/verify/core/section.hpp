// What the grammar of a certificate and the mathematics of a section know of each other.
#pragma once
#include <string_view>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"

namespace dumbbell_verify {

/// An exact box; the third axis is the mass ratio q = heavy / light >= 1, the last one rho of a body.
struct Box {
    std::array<mpq_class, 4> lo, hi;
};

/// One thing to check: a leaf of a tree, a cover of one line, or a witness (the box: one point times [A, B]
/// and [R0, R1]).
struct Leaf {
    std::size_t chart = 0, opcode = 0;
    mpz_class a = 0, b = 0, claimed = 0;  ///< two hints; U of the piece, for a witness V
    std::uint64_t line = 0;
    unsigned bits = 53;  ///< working precision; double is tried first unless `multiple`
    bool multiple = false;
    Box box;
    std::vector<std::pair<mpz_class, mpq_class>> orbits;  ///< pairs behind a
};

enum class Place { leaf, cover, witness };

struct Opcode {
    std::string_view name;
    Place place;
    unsigned charts, hints;  ///< bit set of its charts; number of its hints: 0 to 2; 3: one, and pairs
};
/// The places of the opcodes in every section's table; one that it does not have occurs in no chart.
enum { count_leaf, outside, meets, meets_reversed, equal_masses, witness };

struct Chart {
    std::string_view name;               ///< empty: there are no trees, only covers of one line
    std::vector<std::string_view> axes;  ///< an empty name: no such axis
};

/// A section of one scene with one set of lemmas, with its opcodes in the order of the trailer. `check`
/// returns nullptr if everything that format.md demands of the leaf is certified, else what is not; a log
/// gets a line for every inequality.
struct Section {
    std::string_view lemmas, scene, name, witness;
    std::vector<Chart> charts;
    std::vector<Opcode> opcodes;
    Box (*root)(std::size_t chart, const mpq_class& a, const mpq_class& b);
    const char* (*check)(const Leaf& leaf, Log* log);
    bool heavy_once = false;  ///< a cover also proves that the heavy mass touches the floor at most once
    std::string_view other_witness{};  ///< of a second kind; it has the chart 1
    bool every_body = false;           ///< any rho <= 1 and Q > 0; else q >= 1, and Q rho >= 1 (L70)
    Proof (*read)(Text& text, const Settings& settings) = nullptr;  ///< a file that has no pieces
};

/// The least 2^k >= x, k >= 0. Precondition: x > 0.
inline mpq_class power_of_two(const mpq_class& x) {
    const mpz_class least =
        (x.get_num() - 1) / x.get_den();  // of the integers that are not less than x, less 1
    return mpz_class(mpz_class(1) << (least == 0 ? 0 : mpz_sizeinbase(least.get_mpz_t(), 2)));
}

const Section &turning(), &full(), &plain(), &body(), &perpendicular(), &cells();

/// All of them: (lemmas, scene, name) chooses.
inline std::array<const Section*, 6> sections() {
    return {&turning(), &full(), &plain(), &body(), &perpendicular(), &cells()};
}

}  // namespace dumbbell_verify
