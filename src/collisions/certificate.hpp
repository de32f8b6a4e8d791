#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "file/lines.hpp"
#include "number/count.hpp"
#include "number/rational.hpp"

/// What a certificate says, as data: the claim, and for each piece of the ratio range the tree and the
/// witness that prove it. The format is format.md; nothing here checks anything, the independent
/// verifier does.
namespace dumbbell::collisions {

/// The system: the dumbbell, one of the source paper's model wedges (lemmas L17, L18), or a rigid body with
/// mass between its contacts (body.md).
enum class Scene { dumbbell, hybrid, wedge, body };

/// Of bodies: rho = d2/d1, in [lo, hi] for all of a certificate. What is the mass ratio of others is Q =
/// (d1/k)^2.
struct Heights {
    Rational lo, hi;
};

/// What a cover covers: the turning collisions and the bridge contacts (L8, L9), or all collision states,
/// counted forward only (L15); `plain` is the latter without monotonicity (L16).
enum class Section { turning, full, plain };

/// A family of states that boxes cover. Turning section of the dumbbell: contacts with the bridge (L8), and
/// turning collisions with a light wall of trajectories that never touch the bridge (L9). Full section:
/// contacts with the bridge and departures from a light wall in any direction (L15), and once more the
/// contacts, for what comes back to the bridge (L19). Model wedges: slopes of turning collisions (L17, L18).
/// `corner` is for witnesses of bodies only: orbits near the corner (L73).
enum class Chart { bridge, light, contact, departure, plain_contact, plain_departure, again, wedge, corner };

/// The axes of a chart's boxes: the position e, the slope (eta in the chart bridge, lambda in the chart
/// light), the mass ratio q, and rho of bodies.
enum class Axis : std::uint8_t { position, slope, ratio, rho };
inline constexpr std::size_t axis_count = 4;

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

/// The proof of an upper bound: a tree for each chart of the section, or a lemma.
struct Cover {
    bool equal_masses = false;  ///< L7: the dumbbell with q = 1
    bool symmetric = false;     ///< L72: bodies with rho = 1
    std::vector<ChartTree> charts;

    [[nodiscard]] long leaves() const;
};

/// A collision from which at least `forward` later and `backward` earlier collisions are certain, for every
/// ratio of its piece: 1 + forward + backward in all. Chart bridge: the contact at corner distance e and
/// steepness eta (L11). Chart wedge: a collision with scaled slope lambda in place of eta; it has no scale,
/// e = 0 (L17, L18). Chart corner: e = eta = 0.
struct Witness {
    Rational e;
    Rational eta;
    Count forward{};
    Count backward{};
    Chart chart = Chart::bridge;

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
    Scene scene = Scene::dumbbell;
    Section section = Section::turning;
    std::optional<Heights> heights{};  ///< of the scene body
    std::string sha256{};  ///< as its last line has it, if that is right; empty unless it was read

    [[nodiscard]] const Rational& q_lo() const { return pieces.front().q_lo; }
    [[nodiscard]] const Rational& q_hi() const { return pieces.back().q_hi; }
};

}  // namespace dumbbell::collisions
