#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "file/limits.hpp"
#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// What the general code asks of a section. A new one is a value of Section, a file in sections/ that defines
/// its row, and a line in section.cpp.
namespace dumbbell::collisions {

/// Where the maximum steps: from n - 1 below `critical` to n above.
struct Step {
    long n = 0;
    Rational critical = 0;
    Rational slack = 0;  ///< the true step may be so far from `critical`, relatively
    bool exact = false;  ///< n - 1 holds at `critical` itself, which is the critical ratio exactly
};

/// What to try first of a piece, with the bits of I: only time is lost where it is wrong.
template <class I>
struct BoundSearch {
    /// The maximum at q; nothing if this precision does not tell it, or not in time.
    std::optional<Count> (*maximum)(const Rational& q, const System& system, const Interrupted& interrupted);
    /// Whether an orbit of n collisions at q may be found with this precision; nullptr: always.
    bool (*may_reach)(const Count& n, const Rational& q, const Interrupted& interrupted);
    /// Whether a cover for at most n at q may be found; nullptr: always.
    bool (*may_stay)(const Count& n, const Rational& q, const Interrupted& interrupted);
    std::optional<Witness> (*witness)(const Range& range, const Count& target, const System& system,
                                      const Interrupted& interrupted);
    /// What proves the upper bound without trees, if anything does; nullptr: nothing.
    std::optional<Cover> (*by_lemma)(const Range& range, const Count& upper, const System& system,
                                     const Interrupted& interrupted) = nullptr;
};

struct SectionRow {
    static constexpr int few_bits = 32;

    std::string_view scene, section;           ///< as users say it
    std::string_view lemmas, section_in_file;  ///< the words after `lemmas` and `section`
    std::string_view kind_in_totals = {};      ///< of leaves or covers that no other section has; or nothing
    std::string_view hits, hits_it;            ///< "no ... more than N times, and some ... N times"
    std::string_view growth;  ///< it steps about where growth sqrt q is a whole number: a decimal
    int most_digits = 36;     ///< single ratios up to 10^this are tried
    bool has_orbits = false;  ///< that can be listed and drawn
    /// The source paper bounds its maximum by ceil(pi/gamma) + 1.
    bool has_paper_bound = false;
    bool shows_heavy_once =
        false;  ///< its cover proves that the heavy mass hits the floor at most once (L19)
    /// The bits that the verifier needs beyond those that sufficed here; 0: twice as many are needed.
    int bits_to_verify = few_bits;
    /// The limits of a piece: its precision, and the nodes of a tree.
    int max_bits = most_file_bits - few_bits;
    std::size_t max_nodes = 20'000;
    std::span<const Chart> charts;  ///< in the order of the file; none: there are no trees
    long exact_step = 1;            ///< a ratio at which the maximum is known to step
    /// The step to n, for a gap of this width around it; `critical` is 0 if interrupted. nullptr: nothing is
    /// known of the steps, and ranges are halved.
    Step (*step)(long n, double gap, const Interrupted& interrupted) = nullptr;
    bool is_monotone = false;  ///< where ranges are halved: the maximum does not decrease
    std::tuple<BoundSearch<Interval>, BoundSearch<BigInterval>> bounds;
};

[[nodiscard]] const SectionRow& row_of(Section section);

/// The row that says where the maximum of the system steps: of symmetric bodies that is known (L72).
[[nodiscard]] const SectionRow& staircase_of(const System& system);

/// What row_of gives, each defined where its section is.
extern const SectionRow turning_row, full_row, plain_row, body_row, plain_body_row, symmetric_row;

/// The section of a scene: by the words that users say, or by those of a file; nothing if there is none.
[[nodiscard]] std::optional<Section> section_named(std::string_view scene, std::string_view section);
[[nodiscard]] std::optional<Section> section_in_file(std::string_view scene, std::string_view lemmas,
                                                     std::string_view section);

}  // namespace dumbbell::collisions
