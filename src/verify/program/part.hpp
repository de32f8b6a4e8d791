// A part of a certificate that was verified by itself: what is said of it.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "verify/program/piece_sums.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// For each piece of the part the whole verdict of format.md holds; of the other pieces nothing is said but
/// that the file is well-formed there. A verifier with other rules has another version.
struct Part {
    Pieces pieces;
    std::uint64_t of = 0;  ///< number of pieces of the file
    std::string scene, section;
    mpq_class lo, hi;  ///< of the part, as the bounds
    Bounds bounds;
    unsigned precision = 0;  ///< that was demanded, see Settings
    std::string digest;      ///< of the whole file
};

/// `I-J`, or `I` for one; without any pieces if it is neither, or not 1 <= I <= J.
Pieces parse_pieces(std::string_view text);

/// A proof of the file with these settings says this of the pieces, which it must have kept.
Part part_of(const Proof& proof, const Settings& settings, const PieceSums& sums, const Pieces& pieces);

/// `name=value`, all that a line of a part has after `s PART`.
struct Field {
    std::string_view name;
    std::string value;
};
using Fields = std::array<Field, 12>;
constexpr std::size_t pieces_field = 0, precision_field = 9, digest_field = 11;
Fields fields(const Part& part);

/// `pieces=I-J of=N scene=S section=S ratio=LO:HI upper=U lower=L gaps=G open=O precision=BITS verifier=V
/// sha256=HEX`: the fields, with one space between any two. The last one has 64 digits always, so that what a
/// full disk has cut off is no such line.
std::string part_text(const Part& part);

}  // namespace dumbbell_verify
