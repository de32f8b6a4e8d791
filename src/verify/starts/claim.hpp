// The claim kind `initial-conditions`: what a file says of its box, and whether it proves what is demanded.
#pragma once
#include <array>

#include "verify/format/claim.hpp"

namespace dumbbell_verify {

/// phi, phidot, y, ydot and the mass ratio q, in this order.
inline constexpr std::array<std::string_view, 5> initial_axes{"phi", "phidot", "y", "ydot", "q"};
struct InitialBox {
    std::array<mpq_class, initial_axes.size()> lo, hi;
};

/// Every regular trajectory that starts in the box has at least `least` and, if it is a number, at most
/// `most` collisions; on the share `decided` of the box's volume their exact number is proved.
struct Initial {
    static constexpr std::string_view leaves = "box, box.01, ...";  ///< as --explain names them
    InitialBox box;
    std::uint64_t least = 0;
    std::optional<std::uint64_t> most;
    mpq_class decided;

    /// Empty if this proves the bounds and contains the ratios that are demanded.
    [[nodiscard]] std::string missing(const Collisions& demand) const;
    /// For the verdict: the box, the range of collisions and the share, rounded down.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] static std::string paragraph() { return ""; }
    [[nodiscard]] std::string json() const;
};

}  // namespace dumbbell_verify
