#include "verify/wings/starts/claim.hpp"

#include <cmath>

#include "verify/machine/decimals.hpp"
#include "verify/machine/integer.hpp"
#include "verify/wings/starts/mean.hpp"

namespace dumbbell_verify::starts {
namespace {

std::string shares_json(const Shares& shares) {
    std::string text;
    for (const Shares::Row& row : shares.rows())
        text += (text.empty() ? "{\"least\":" : ",{\"least\":") + std::to_string(row.least) +
                ",\"most\":" + (row.most ? std::to_string(*row.most) : "null") + ",\"lo\":\"" +
                to_string(row.lo) + "\",\"hi\":\"" + to_string(row.hi) + "\"}";
    return "[" + text + "]";
}

/// With six decimals, rounded outward; empty if there is no such number, at ratios that doubles do not hold.
std::string six_decimals(const Interval<double>& x, const char* between) {
    if (!std::isfinite(x.hi)) return "";
    return decimals(mpq_class(x.lo), false) + between + decimals(mpq_class(x.hi), true);
}

std::string mean_json(const Shares& shares, const Means& exact) {
    const auto pair = [](const Interval<double>& x) {
        const std::string text = six_decimals(x, "\",\"");
        return text.empty() ? "null" : "[\"" + text + "\"]";
    };
    return "{\"lo\":\"" + to_string(shares.least_mean) +
           "\",\"hi\":" + (shares.open == 0 ? "\"" + to_string(shares.most_mean) + "\"" : "null") +
           ",\"exact\":" + pair(exact.all) + ",\"heavy\":" + pair(exact.heavy) + "}";
}

std::string mean_text(const Shares& shares, const Means& exact) {
    const std::string all = six_decimals(exact.all, " to "), heavy = six_decimals(exact.heavy, " to ");
    return "  The mean number of collisions is " +
           (shares.open == 0 ? decimals(shares.least_mean, false) + " to " + decimals(shares.most_mean, true)
                             : "at least " + decimals(shares.least_mean, false)) +
           " by the leaves" + (all.empty() ? "" : ", and " + all + " by Theorem 6") + ".\n" +
           (heavy.empty() ? "" : "  The heavy mass hits the floor with probability " + heavy + ".\n");
}

}  // namespace

std::string header_name(std::size_t axis) { return axis == 4 ? "ratio" : std::string(axis_names[axis]); }

std::string Claim::text() const {
    std::string result = "claim=" + std::string(kind_name());
    for (std::size_t i = incoming ? 4 : 0; i < axis_names.size(); ++i)
        result += " " + header_name(i) + "=" + to_string(box.lo[i], box.hi[i]);
    return result + " collisions=" + std::to_string(least) + ":" + (most ? std::to_string(*most) : "none") +
           " decided=" + (decided == 1 ? "1" : decimals(decided, false, share_places));
}

std::string Claim::json() const {
    std::string sides;
    for (std::size_t i = incoming ? 4 : 0; i < axis_names.size(); ++i)
        sides += (sides.empty() ? "\"" : ",\"") + header_name(i) + "\":{\"lo\":\"" + to_string(box.lo[i]) +
                 "\",\"hi\":\"" + to_string(box.hi[i]) + "\"}";
    return (incoming ? "{\"kind\":\"incoming\"," + sides
                     : "{\"kind\":\"initial-conditions\",\"box\":{" + sides + "}") +
           ",\"least\":" + std::to_string(least) + ",\"most\":" + (most ? std::to_string(*most) : "null") +
           ",\"decided\":\"" + to_string(decided) + "\"" +
           (shares ? ",\"shares\":" + shares_json(*shares) : "") +
           (shares && incoming ? ",\"mean\":" + mean_json(*shares, means(box.lo.back())) : "") + "}";
}

std::string Claim::sentence() const {
    const auto& [fewest, greatest, share] = asked;
    const std::string all = incoming         ? "every trajectory that comes in"
                            : asks_of_part() ? "every start in the demanded part of the box"
                                             : "every start in the box";
    std::string text = "No bound is proved that holds for " + all;
    if (greatest || fewest > 0)
        text = "Proved: for " + all + " the dumbbell hits the floor " +
               (!greatest            ? "at least " + std::to_string(fewest)
                : *greatest > fewest ? "from " + std::to_string(fewest) + " to " + std::to_string(*greatest)
                                     : std::to_string(fewest)) +
               (greatest.value_or(fewest) == 1 ? " time" : " times");
    if (greatest == fewest || (!greatest && fewest == 0 && share == 0)) return text;
    return text + "; the number is known for " +
           (share == 1   ? "each"
            : share == 0 ? "none"
                         : "at least a share " + decimals(share, false, share_places) + " of all");
}

std::string Claim::paragraph() const {
    std::string text = "  " + sentence() + ".\n";
    if (!shares) return text;
    if (incoming) text += mean_text(*shares, means(box.lo.back()));
    text += "  collisions  share of the " + std::string(incoming ? "trajectories" : "box") +
            " with exactly that many: proved bounds\n";
    for (const Shares::Row& row : shares->rows()) {
        const std::string counts = std::to_string(row.least) + (row.most == row.least ? "" : "-") +
                                   (row.most && *row.most > row.least ? std::to_string(*row.most) : "");
        text += std::string(counts.size() < 12 ? 12 - counts.size() : 0, ' ') + counts + "  " +
                decimals(row.lo, false, share_places) + " to " + decimals(row.hi, true, share_places) + "\n";
    }
    return text;
}

void Shares::add(std::uint64_t least, std::uint64_t most, const mpq_class& volume) {
    if (least == most) counts[least].exact += volume;
    const auto times = [&](std::uint64_t n) { return mpq_class(volume * integer(n)); };
    least_mean += times(least);
    most_mean += times(most);
    counts[least].change += volume;
    counts[most + 1].change -= volume;
}

std::vector<Shares::Row> Shares::rows() const {
    std::vector<Row> rows;
    mpq_class hi = open;
    if (!counts.contains(0)) rows.push_back({0, std::nullopt, 0, hi});
    for (const auto& [count, leaves] : counts) {
        if (!rows.empty()) rows.back().most = count - 1;
        hi += leaves.change;
        rows.push_back({count, std::nullopt, leaves.exact, hi});
    }
    if (open == 0) rows.pop_back();
    for (Row& row : rows)
        if (row.most != row.least) row.lo = 0;  // exact volumes are of one number
    return rows;
}

}  // namespace dumbbell_verify::starts
