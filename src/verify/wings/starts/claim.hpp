// The claim kind `initial-conditions`: what a file says of its box, and whether it proves what is demanded.
#pragma once
#include <array>
#include <map>

#include "verify/kinds/other_claim.hpp"

namespace dumbbell_verify::starts {

inline constexpr unsigned share_places = 12;

/// phi, phidot, y, ydot and the mass ratio q, in this order.
inline constexpr std::array<std::string_view, 5> axis_names{"phi", "phidot", "y", "ydot", "q"};
struct Box {
    std::array<mpq_class, axis_names.size()> lo, hi;
    friend bool operator==(const Box&, const Box&) = default;
};
std::string header_name(std::size_t axis);  ///< that the first lines of a file have for it

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

/// Every regular trajectory that starts in a box has at least `least` and, if it is a number, at most
/// `most` collisions; on the share `decided` of the box's volume their exact number is proved.
struct Known {
    std::uint64_t least = 0;
    std::optional<std::uint64_t> most;
    mpq_class decided;

    /// And from `a` to `b` in a part that has this share. Of no part: {UINT64_MAX, 0, 0}.
    void join(std::uint64_t a, const std::optional<std::uint64_t>& b, const mpq_class& share) {
        least = std::min(least, a);
        most = most && b ? std::max(most, b) : std::nullopt;
        if (a == b) decided += share;
    }
};

/// What is known of the file's box.
struct Claim : Known, OtherClaim {
    bool incoming = false;  ///< not a box, but all incoming trajectories (format-initial.md, section 8)
    Box box;
    Box asked_box;                 ///< the one in question
    Known asked;                   ///< of that
    std::optional<Shares> shares;  ///< of `box`, if they were asked for

    [[nodiscard]] std::string_view kind_name() const override {
        return incoming ? "incoming" : "initial-conditions";
    }
    [[nodiscard]] std::string_view leaves() const override { return "box, box.01, ..."; }
    [[nodiscard]] bool asks_of_part() const { return asked_box != box; }
    /// No bound is demanded, none holds for all that is in question, and no part of that is decided.
    [[nodiscard]] bool says_nothing(const Collisions& demand) const override {
        return !demand.most && !demand.least && !asked.most && asked.least == 0 && asked.decided == 0;
    }
    /// For the verdict: the box, the range of collisions and the share, rounded down.
    [[nodiscard]] std::string text() const override;
    [[nodiscard]] std::string json() const override;
    /// What is proved of the box in question, in English, without its full stop.
    [[nodiscard]] std::string sentence() const;
    /// The sentence, and a line for each row of the shares, with twelve decimals rounded outward.
    [[nodiscard]] std::string paragraph() const override;
};

}  // namespace dumbbell_verify::starts
