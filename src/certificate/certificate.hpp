#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arith/rational.hpp"

/// What a certificate says, as data: the claim, and for each piece of the ratio range the tree and the
/// witness that prove it. The format is proofs/format.md; nothing here checks anything, the independent
/// verifier does.
namespace dumbbell {

/// The two charts of the turning section: contacts with the bridge (L8), and turning collisions with a light
/// wall of trajectories that never touch the bridge (L9).
enum class Chart { bridge, light };

/// The axes of a chart's boxes: the position e, the slope (eta in the chart bridge, lambda in the chart
/// light) and the mass ratio q.
enum class Axis { position, slope, ratio };

/// The one reason for which a leaf's states need no further look (proofs/format.md, sections 3.3 and 3.4).
enum class Reason { count, outside, meets, meets_reversed };

/// A closed leaf. For Reason::count: the outgoing ray X has at most `forward` later collisions and the
/// reversed incoming ray sigma X at most `backward`.
struct Leaf {
    Reason reason = Reason::count;
    long forward = 0;
    long backward = 0;
};

/// One node of a bisection tree in pre-order: an inner node names the axis of its split and is followed by
/// its lower, then its upper subtree; a leaf has its reason.
struct Node {
    std::optional<Axis> split;
    Leaf leaf{};
};
using Tree = std::vector<Node>;

/// The proof of an upper bound: both charts' trees, or (q = 1 only) lemma L7.
struct Cover {
    bool equal_masses = false;
    Tree bridge;
    Tree light;

    [[nodiscard]] long leaves() const;
};

/// A contact with the bridge at corner distance e and steepness eta (chart bridge), from which at least
/// `forward` later and `backward` earlier collisions are certain, for every ratio of its piece (lemma L11): 1
/// + forward + backward in all.
struct Witness {
    Rational e;
    Rational eta;
    long forward = 0;
    long backward = 0;

    [[nodiscard]] long total() const { return 1 + forward + backward; }
};

enum class Status { exact, gap, open };

/// Mass ratios [q_lo, q_hi] with what is proved of all of them: at most `upper` collisions (if given) and at
/// least `lower` by some trajectory.
struct Piece {
    Rational q_lo;
    Rational q_hi;
    int bits = 53;
    std::optional<long> upper;
    Cover cover;
    long lower = 0;
    std::optional<Witness> witness;

    [[nodiscard]] Status status() const;
};

struct Certificate {
    std::string program;
    std::string version;
    std::vector<Piece> pieces;  ///< in order, each begins where the one before ends; not empty

    [[nodiscard]] const Rational& q_lo() const { return pieces.front().q_lo; }
    [[nodiscard]] const Rational& q_hi() const { return pieces.back().q_hi; }
};

}  // namespace dumbbell
