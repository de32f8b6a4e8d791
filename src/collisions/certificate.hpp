#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "file/lines.hpp"
#include "number/count.hpp"
#include "number/rational.hpp"

/// What a certificate says, as data: the claim, and for each piece of the ratio range the tree and the
/// witness that prove it. The format is format.md; nothing here checks anything, the independent
/// verifier does.
namespace dumbbell::collisions {

/// A closed range of exact numbers: mass ratios, or of bodies Q = (d1/k)^2.
struct Range {
    Rational lo, hi;

    [[nodiscard]] bool is_single() const { return lo == hi; }
    friend bool operator==(const Range&, const Range&) = default;
};

/// What is covered. Of the dumbbell: the turning collisions and the bridge contacts (L8, L9), all collision
/// states, counted forward only (L15), or the latter without monotonicity (L16). All collision states of
/// rigid bodies with mass between their contacts (body.md). What is known of each is a row (section.hpp).
enum class Section { turning, full, plain, body, plain_body };

/// What moves, and what of its states is covered.
struct System {
    Section section;
    std::optional<Rational> rho;  ///< d2/d1 of a body, and of nothing else

    // NOLINTNEXTLINE(google-explicit-constructor): a section is all that most need
    System(Section covered = Section::turning, std::optional<Rational> height = std::nullopt)
        : section(covered), rho(std::move(height)) {}
    friend bool operator==(const System&, const System&) = default;
};

/// A family of states that boxes cover, of a section (sections/). What is known of each is a row (chart.hpp).
enum class Chart { bridge, light, contact, departure, plain_contact, plain_departure, again };

/// The axes of a chart's boxes: the position e, the slope (eta in the chart bridge, lambda in the chart
/// light), and the mass ratio q, or Q of bodies.
enum class Axis : std::uint8_t { position, slope, ratio };
inline constexpr std::array all_axes{Axis::position, Axis::slope, Axis::ratio};
inline constexpr std::size_t axis_count = all_axes.size();

/// The one reason for which a leaf's states need no further look (format.md, sections 3.3 and 3.4).
enum class Reason : std::uint8_t { count, outside, meets, meets_reversed, once };

/// A closed leaf. For Reason::count: the outgoing ray X has at most `forward` later collisions and the
/// reversed incoming ray sigma X at most `backward`.
struct Leaf {
    Reason reason = Reason::count;
    Count forward{};
    Count backward{};
};

/// One node of a bisection tree in pre-order: an inner node names the axis of its split and is followed by
/// its lower, then its upper subtree; a leaf has its reason.
struct Node {
    std::optional<Axis> split;
    Leaf leaf{};
};
using Tree = std::vector<Node>;

struct ChartTree {
    Chart chart;
    Tree tree;
};

/// An upper bound of bodies by orbits (x, p), and J < end (plane.md, L87 (a)).
struct UpperBound {
    long end = 0;
    std::vector<std::pair<long, Rational>> orbits{};
};

/// The proof of an upper bound: a tree for each chart of the section, a lemma, or orbits.
struct Cover {
    bool equal_masses = false;  ///< L7: the dumbbell with q = 1
    bool symmetric = false;     ///< L72: bodies with rho = 1
    std::optional<UpperBound> orbits{};
    std::vector<ChartTree> charts;

    [[nodiscard]] long leaves() const;
};

/// A collision from which at least `forward` later and `backward` earlier collisions are certain, for every
/// ratio of its piece: 1 + forward + backward in all. On the bridge: the contact at corner distance e and
/// steepness eta (L11). In the corner of a body (L73): e = eta = 0.
enum class Place { bridge, corner };
struct Witness {
    Rational e;
    Rational eta;
    Count forward{};
    Count backward{};
    Place place = Place::bridge;

    [[nodiscard]] Count total() const { return 1 + forward + backward; }
};

enum class Status { exact, gap, open };

/// Mass ratios [q_lo, q_hi] with what is proved of all of them: at most `upper` collisions (if given) and at
/// least `lower` by some trajectory.
struct Piece {
    Rational q_lo;
    Rational q_hi;
    int bits = 53;
    std::optional<Count> upper;
    Cover cover;
    Count lower{};
    std::optional<Witness> witness;

    [[nodiscard]] Status status() const;
};

struct Certificate {
    Generator generator{};
    std::vector<Piece> pieces;  ///< in order, each begins where the one before ends; not empty
    System system{};
    std::string sha256{};  ///< as its last line has it, if that is right; empty unless it was read

    [[nodiscard]] const Rational& q_lo() const { return pieces.front().q_lo; }
    [[nodiscard]] const Rational& q_hi() const { return pieces.back().q_hi; }
    [[nodiscard]] Range range() const { return {q_lo(), q_hi()}; }
    [[nodiscard]] long leaves() const;
};

}  // namespace dumbbell::collisions
