#include "campaign/plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "base/fields.hpp"

namespace dumbbell::campaign {

Order Plan::order(std::size_t first, std::size_t end) const {
    return {whole.head,
            {whole.units.begin() + static_cast<std::ptrdiff_t>(first),
             whole.units.begin() + static_cast<std::ptrdiff_t>(end)}};
}

std::vector<Plan::Shard> even_shards(const std::vector<std::size_t>& costs, std::size_t wanted) {
    const std::size_t whole = std::reduce(costs.begin(), costs.end());
    std::vector<Plan::Shard> shards;
    std::size_t before = 0;  // cost of all units so far
    Plan::Shard shard;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        before += costs[i];
        shard.end = i + 1;
        shard.cost += costs[i];
        // The k-th shard ends where k/wanted of the whole is reached.
        const bool is_full = static_cast<double>(before) * static_cast<double>(wanted) >=
                             static_cast<double>(whole) * static_cast<double>(shards.size() + 1);
        if (is_full || i + 1 == costs.size()) {
            shards.push_back(shard);
            shard = {i + 1, i + 1, 0};
        }
    }
    return shards;
}

std::vector<Plan::Shard> cut(const std::vector<std::size_t>& costs, std::optional<std::size_t> wish,
                             std::size_t usual) {
    const std::size_t whole = std::reduce(costs.begin(), costs.end());
    return even_shards(costs, wish.value_or(std::max(many_shards, whole / usual)));
}

std::string render(const Plan& plan) {
    SealedLines out;
    out.line("dumbbell-campaign 1");
    out.line("generator dumbbell {}", DUMBBELL_VERSION);
    out.line("claim {}", plan.claim);
    write_order(out, plan.whole);
    out.line("inputs {}", plan.inputs.size());
    for (const std::string& input : plan.inputs) {
        out.line("{}", input);
    }
    out.line("shards {}", plan.shards.size());
    for (const Plan::Shard& shard : plan.shards) {
        out.line("shard {} {} {}", shard.first, shard.end, shard.cost);
    }
    return std::move(out).sealed().text;
}

Plan parse_plan(const std::string& text) {
    SealedReader in(text, "the plan of a campaign");
    if (in.line() != "dumbbell-campaign 1") {
        in.fail();
    }
    const std::string_view generator = in.value("generator");
    if (generator != "dumbbell " DUMBBELL_VERSION) {
        throw InputError(
            fmt::format("the campaign was planned by {}, and this is dumbbell {}: go on with that "
                        "version, or plan the claim anew in another folder",
                        generator, DUMBBELL_VERSION));
    }
    Plan plan;
    plan.claim = in.value("claim");
    plan.whole = read_order(in);
    for (std::size_t count = in.number("inputs"); count > 0; --count) {
        plan.inputs.emplace_back(in.line());
    }
    std::size_t covered = 0;
    for (std::size_t count = in.number("shards"); count > 0; --count) {
        const auto fields = split(in.value("shard"), ' ');
        if (fields.size() != 3) {
            in.fail();
        }
        const Plan::Shard shard{parse_size(fields[0]), parse_size(fields[1]), parse_size(fields[2])};
        if (shard.first != covered || shard.end <= shard.first) {
            in.fail();
        }
        covered = shard.end;
        plan.shards.push_back(shard);
    }
    if (covered != plan.whole.units.size() || covered == 0) {
        in.fail();
    }
    in.end();
    return plan;
}

}  // namespace dumbbell::campaign
