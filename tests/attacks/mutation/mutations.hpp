// The mutants of one certificate: small changes of its text, its trees and its claims, each of them once.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bases.hpp"
#include "text.hpp"

namespace dumbbell_mutation {

/// By how much a claim's numbers are changed, relatively, and what its working bits are changed to.
inline constexpr const char* steps[] = {"1e-15", "1e-9", "1e-4", "1e-2", "1/3", "1"};
inline constexpr std::array bit_counts{53, 54, 64, 96, 113, 200, 256, 512, 1024, 2048, 4096};

/// A changed text, its trailer not yet made anew, or bytes that are to be verified as they are. `what` says
/// in one line what was changed.
struct Mutant {
    std::string_view kind;
    std::string what, text;
    bool as_it_is = false;
};
using Sink = std::function<void(Mutant)>;

struct ChangedLine {
    std::string_view kind;
    std::string line;
};
/// The line with one word changed, in all the ways of word_mutations.
[[nodiscard]] std::vector<ChangedLine> changed_lines(const std::string& line);

/// Each word deleted, doubled, exchanged with the next; numbers one more, one less, negated, huge, zero,
/// nearly the same, spelled otherwise; words replaced by every other of their class.
void word_mutations(const std::string& text, const Sink& sink);
/// Each line deleted, doubled, exchanged with the next, with bytes that do not belong there.
void line_mutations(const std::string& text, const Sink& sink);
/// The text, and the same compressed, cut off at every byte and with bits changed in every byte; bytes after
/// the end.
void byte_mutations(const std::string& text, const Sink& sink);
/// Halves exchanged, leaves lifted to their parents and to the root, opcodes replaced by every other, axes
/// exchanged, leaves split, charts and pieces deleted, doubled and exchanged.
void tree_mutations(const std::string& text, const Sink& sink);
/// Stronger and other claims, consistently in all lines: N less with the same tree, lesser hints or the best
/// tree there is; one more attained; wider and other ranges and boxes, pieces merged, other working bits and
/// sections.
void claim_mutations(const Base& base, const Sink& sink);
/// Those of a file about the adiabatic invariant: other ranges, margins, bounds, classes and attained states.
void adiabatic_claim_mutations(const dumbbell::adiabatic::Certificate& data, const Sink& sink);
/// `count` texts with two to four random changes of words, lines and trees at once.
void random_mutations(const std::string& text, std::uint64_t seed, std::size_t count, const Sink& sink);

}  // namespace dumbbell_mutation
