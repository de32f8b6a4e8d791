#include "verify/starts/claim.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::size_t decimals = 12;
constexpr long one = 1'000'000'000'000;  // 10^decimals

std::string decimal(const mpz_class& units) {
    const std::string digits = units.get_str();
    return "0." + std::string(decimals - digits.size(), '0') + digits;
}
/// x in [0, 1] with twelve decimals, rounded down.
std::string decimal(const mpq_class& x) {
    return x >= 1 ? "1" : decimal(mpz_class(x.get_num() * one / x.get_den()));
}
/// The same with all decimals of 1, rounded down or up.
std::string bound(const mpq_class& x, bool up) {
    mpz_class units = x.get_num() * one;
    if (up) units += x.get_den() - 1;
    units /= x.get_den();
    return units >= one ? "1." + std::string(decimals, '0') : decimal(units);
}

std::string shares_json(const StartShares& shares) {
    std::string text;
    for (const StartShares::Row& row : shares.rows())
        text += (text.empty() ? "{\"least\":" : ",{\"least\":") + std::to_string(row.least) +
                ",\"most\":" + (row.most ? std::to_string(*row.most) : "null") + ",\"lo\":\"" +
                to_string(row.lo) + "\",\"hi\":\"" + to_string(row.hi) + "\"}";
    return "[" + text + "]";
}

/// The name that the header of a file has for an axis.
std::string header_name(std::size_t axis) { return axis == 4 ? "ratio" : std::string(initial_axes[axis]); }

}  // namespace

std::string Initial::missing(const Collisions& demand) const {
    const mpq_class &lo = box.lo.back(), &hi = box.hi.back();
    if (demand.ratios && (demand.ratios->first < lo || demand.ratios->second > hi))
        return covered_part(lo, hi, demand.ratios->first, demand.ratios->second);
    if (demand.most && (!most || *most > *demand.most))
        return "not proved: at most " + demand.most->get_str() + " collisions from the box";
    if (demand.least && least < *demand.least)
        return "not proved: at least " + demand.least->get_str() + " collisions from the box";
    return "";
}

std::string Initial::text() const {
    std::string result = incoming ? "claim=incoming" : "claim=initial-conditions";
    for (std::size_t i = incoming ? 4 : 0; i < initial_axes.size(); ++i)
        result += " " + header_name(i) + "=" + to_string(box.lo[i], box.hi[i]);
    return result + " collisions=" + std::to_string(least) + ":" + (most ? std::to_string(*most) : "none") +
           " decided=" + decimal(decided);
}

std::string Initial::json() const {
    const auto range = [&](std::size_t i) {
        return "\"" + header_name(i) + "\":{\"lo\":\"" + to_string(box.lo[i]) + "\",\"hi\":\"" +
               to_string(box.hi[i]) + "\"}";
    };
    std::string result = "{\"kind\":\"initial-conditions\",\"box\":{";
    for (std::size_t i = 0; i < initial_axes.size(); ++i) result += (i > 0 ? "," : "") + range(i);
    return (incoming ? "{\"kind\":\"incoming\"," + range(4) : result + "}") +
           ",\"least\":" + std::to_string(least) + ",\"most\":" + (most ? std::to_string(*most) : "null") +
           ",\"decided\":\"" + to_string(decided) + "\"" +
           (shares ? ",\"shares\":" + shares_json(*shares) : "") + "}";
}

std::string Initial::paragraph() const {
    if (!shares) return "";
    std::string text = "  collisions  share of the " + std::string(incoming ? "trajectories" : "box") +
                       " with exactly that many: proved bounds\n";
    for (const StartShares::Row& row : shares->rows()) {
        const std::string counts = std::to_string(row.least) + (row.most == row.least ? "" : "-") +
                                   (row.most && *row.most > row.least ? std::to_string(*row.most) : "");
        text += std::string(counts.size() < 12 ? 12 - counts.size() : 0, ' ') + counts + "  " +
                bound(row.lo, false) + " to " + bound(row.hi, true) + "\n";
    }
    return text;
}

void StartShares::add(std::uint64_t least, std::uint64_t most, const mpq_class& volume) {
    if (least == most) exact[least] += volume;
    change[least] += volume;
    change[most + 1] -= volume;
}

std::vector<StartShares::Row> StartShares::rows() const {
    std::vector<Row> rows;
    mpq_class hi = open;
    if (!change.contains(0)) rows.push_back({0, std::nullopt, 0, hi});
    for (const auto& [count, by] : change) {
        if (!rows.empty()) rows.back().most = count - 1;
        hi += by;
        const auto found = exact.find(count);
        rows.push_back({count, std::nullopt, found == exact.end() ? mpq_class(0) : found->second, hi});
    }
    if (open == 0) rows.pop_back();
    return rows;
}

}  // namespace dumbbell_verify
