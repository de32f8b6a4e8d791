#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "file/lines.hpp"
#include "number/rational.hpp"

/// A certificate about the adiabatic invariant as data (format-adiabatic.md).
namespace dumbbell::adiabatic {

enum class Claim { bounce, run, scattering };

/// The axes of its boxes; each tree has some of them.
enum class Axis { u, sigma, s, v, delta };
inline constexpr std::size_t axis_count = 5;
/// As certificates spell them.
inline constexpr std::array<std::string_view, axis_count> axis_names{"u", "sigma", "s", "v", "delta"};

/// Without `split` a leaf: `outside`, or `bound`, in the tree of a run or a scattering by the class of that
/// number.
struct Node {
    std::optional<Axis> split;
    bool outside = false;
    int by_class = 0;

    friend bool operator==(const Node&, const Node&) = default;
};
using Tree = std::vector<Node>;  ///< pre-order, lower half first

/// A class of L35: J, and the density v on the cells [u, the cell before's u].
struct Class {
    struct Cell {
        Rational u;
        Rational v;
    };
    Rational least_share;
    std::vector<Cell> cells;
    Tree tree;
};

/// An orbit: |phidot| = 1 and ydot = -delta s before collision 0, at angle u from the vertical; its error
/// after n collisions is at least `value`, in the claim's unit.
struct State {
    Rational u;
    Rational s;
    Rational delta;
    long n = 0;
    Rational value;
};

/// What is claimed of which states.
struct Hypotheses {
    Claim claim = Claim::run;
    std::pair<Rational, Rational> delta;  ///< closed interval
    std::pair<Rational, Rational>
        heights;       ///< of a bounce or a run: of the centre of mass before collision 0
    Rational margin;   ///< m, u_* or c
    int exponent = 8;  ///< of a bounce: k = exponent/16

    [[nodiscard]] bool has_one_delta() const { return delta.first == delta.second; }
};

struct Certificate {
    Generator generator{};
    Hypotheses hypotheses;
    int bits = 53;
    std::vector<Rational> bounds;  ///< C; of a bounce C1 and C2
    std::vector<Class> classes;
    Tree tree;
    std::vector<State> attained;  ///< as many
    std::string sha256{};         ///< as its last line has it, if that is right; empty unless it was read

    [[nodiscard]] bool complete() const {
        const std::size_t values = hypotheses.claim == Claim::bounce ? 2 : 1;
        return bounds.size() == values && attained.size() == values;
    }
};

}  // namespace dumbbell::adiabatic
