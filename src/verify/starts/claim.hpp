// The claim kind `initial-conditions`: what a file says of its box, and whether it proves what is demanded.
#pragma once
#include <array>
#include <map>

#include "verify/core/claim.hpp"

namespace dumbbell_verify::starts {

/// x >= 0 with this number of decimals, rounded up or down.
std::string decimals(const mpq_class& x, bool upward, unsigned places = 6);

/// phi, phidot, y, ydot and the mass ratio q, in this order.
inline constexpr std::array<std::string_view, 5> axis_names{"phi", "phidot", "y", "ydot", "q"};
struct Box {
    std::array<mpq_class, axis_names.size()> lo, hi;
};

/// How likely each number of collisions is (format-initial.md, section 7): the volumes of leaves, in units of
/// the box's.
struct Shares {
    struct Count {
        mpq_class exact;   ///< of the leaves with this number
        mpq_class change;  ///< from the number before: of the leaves that do not exclude this one
    };
    std::map<std::uint64_t, Count> counts;
    mpq_class open;                   ///< of the leaves that exclude nothing
    mpq_class least_mean, most_mean;  ///< of the number of collisions; no bound above if any are open

    void add(std::uint64_t least, std::uint64_t most, const mpq_class& volume);
    /// From `least` to `most` collisions, each of these numbers: the share is at least lo, at most hi.
    struct Row {
        std::uint64_t least;
        std::optional<std::uint64_t> most;
        mpq_class lo, hi;
    };
    /// In ascending order, from 0 on; behind them all shares are 0.
    [[nodiscard]] std::vector<Row> rows() const;
};

/// Every regular trajectory that starts in the box has at least `least` and, if it is a number, at most
/// `most` collisions; on the share `decided` of the box's volume their exact number is proved.
struct Claim {
    static constexpr std::string_view leaves = "box, box.01, ...";  ///< as --explain names them
    bool incoming = false;  ///< not a box, but all incoming trajectories (format-initial.md, section 8)
    Box box;
    std::uint64_t least = 0;
    std::optional<std::uint64_t> most;
    mpq_class decided;
    std::optional<Shares> shares;  ///< if they were asked for

    /// Empty if this proves the bounds and contains the ratios that are demanded, and if the shares have the
    /// mean that all incoming trajectories have.
    [[nodiscard]] std::string missing(const Collisions& demand) const;
    /// No bound is demanded, none holds for all of the box, and no part of it is decided.
    [[nodiscard]] bool says_nothing(const Collisions& demand) const {
        return !demand.most && !demand.least && !most && least == 0 && decided == 0;
    }
    /// For the verdict: the box, the range of collisions and the share, rounded down.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string json() const;
    /// What is proved, in English, without its full stop.
    [[nodiscard]] std::string sentence() const;
    /// The sentence, and a line for each row of the shares, with twelve decimals rounded outward.
    [[nodiscard]] std::string paragraph() const;
};

}  // namespace dumbbell_verify::starts
