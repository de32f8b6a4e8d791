#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/order.hpp"

namespace dumbbell::campaign {

/// A claim cut into shards: runs of units, each unit with an estimate of its cost (in no particular measure).
/// Nothing in it depends on the machine's speed or on the time.
struct Plan {
    struct Shard {
        std::size_t first = 0;
        std::size_t end = 0;  ///< after its last unit
        std::size_t cost = 0;

        friend bool operator==(const Shard&, const Shard&) = default;
    };
    std::string claim;  ///< for people: the command that would prove it in one go
    Order whole;        ///< all units
    std::vector<Shard> shards;
    std::vector<std::string> inputs;  ///< files next to the plan that each order needs

    /// What a shard, or a part of one, is to prove.
    [[nodiscard]] Order order(std::size_t first, std::size_t end) const;

    friend bool operator==(const Plan&, const Plan&) = default;
};

/// The number of shards that are wanted at least, where nobody says how many.
inline constexpr std::size_t many_shards = 64;

/// Cuts units of these costs into at most `wanted` shards of about even cost, in their order. No shard is
/// empty. Precondition: wanted > 0; the costs' sum fits.
[[nodiscard]] std::vector<Plan::Shard> even_shards(const std::vector<std::size_t>& costs, std::size_t wanted);

/// The same, with the user's wish; without one many_shards, or more if otherwise a shard costs more than
/// `usual`.
[[nodiscard]] std::vector<Plan::Shard> cut(const std::vector<std::size_t>& costs,
                                           std::optional<std::size_t> wish, std::size_t usual);

/// A plan as a file with a checksum, and back. Reading throws InputError if it is damaged or was made by
/// another version of the program.
[[nodiscard]] std::string render(const Plan& plan);
[[nodiscard]] Plan parse_plan(const std::string& text);

}  // namespace dumbbell::campaign
