#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "file/lines.hpp"
#include "number/rational.hpp"

/// A certificate about initial conditions as data (format-initial.md).
namespace dumbbell::starts {

/// The axes of a box of initial conditions; the ratio is q = heavy mass / light mass.
enum class Axis { phi, phidot, y, ydot, ratio };
inline constexpr std::size_t axis_count = 5;
/// As certificates spell them.
inline constexpr std::array<std::string_view, axis_count> axis_names{"phi", "phidot", "y", "ydot", "q"};
inline constexpr decltype(axis_names) incoming_names{"phi", "s", "", "", ""};

/// A closed box of initial conditions in physical terms: rod length 1, phi in radians (the light mass is at
/// height y + beta2 sin phi), y the height of the centre of mass. An axis of width 0 is an exact number.
struct Box {
    std::array<Rational, axis_count> lo;
    std::array<Rational, axis_count> hi;
    std::optional<Rational> rho{};  ///< of a body (L70), whose Q is the ratio

    [[nodiscard]] const Rational& lower(Axis axis) const { return lo[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] const Rational& upper(Axis axis) const { return hi[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] bool is_point() const { return lo == hi; }
    /// d1/d2: the mass ratio of the massless dumbbell whose ends are at the same distances.
    [[nodiscard]] Rational ratio_of_distances() const { return rho ? 1 / *rho : lower(Axis::ratio); }
};

/// When all states of a leaf have their first contact, and with which mass.
struct FirstContact {
    bool heavy = false;
    Rational from;
    Rational until;
};

/// Every initial condition of the leaf has at least `least` and at most `most` collisions (nothing claimed if
/// empty: `open`).
struct Leaf {
    long least = 0;
    std::optional<long> most = std::nullopt;
    std::optional<FirstContact> first = std::nullopt;
};

struct Node {
    std::optional<Axis> split;
    Leaf leaf{};
};

struct Certificate {
    Generator generator{};
    Box box;
    int bits = 53;
    std::vector<Node> tree;  ///< pre-order, lower half first
    bool incoming = false;   ///< all incoming trajectories: box, tree in the coordinates of incoming.hpp
    std::string sha256{};    ///< as its last line has it, if that is right; empty unless it was read
};

}  // namespace dumbbell::starts
