#include "verify/starts/claim.hpp"

#include "verify/machine/integer.hpp"

namespace dumbbell_verify::starts {
namespace {

constexpr unsigned share_places = 12;

std::string shares_json(const Shares& shares) {
    std::string text;
    for (const Shares::Row& row : shares.rows())
        text += (text.empty() ? "{\"least\":" : ",{\"least\":") + std::to_string(row.least) +
                ",\"most\":" + (row.most ? std::to_string(*row.most) : "null") + ",\"lo\":\"" +
                to_string(row.lo) + "\",\"hi\":\"" + to_string(row.hi) + "\"}";
    return "[" + text + "]";
}

/// The name that the header of a file has for an axis.
std::string header_name(std::size_t axis) { return axis == 4 ? "ratio" : std::string(axis_names[axis]); }

}  // namespace

std::string decimals(const mpq_class& x, bool upward, unsigned places) {
    mpz_class scale, rest, digits;
    mpz_ui_pow_ui(scale.get_mpz_t(), 10, places);
    const mpz_class scaled = x.get_num() * scale;
    (upward ? mpz_cdiv_q : mpz_fdiv_q)(digits.get_mpz_t(), scaled.get_mpz_t(), x.get_den_mpz_t());
    std::string text = digits.get_str();
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    return places == 0 ? text : text.insert(text.size() - places, ".");
}

std::string Claim::missing(const Collisions& demand) const {
    const mpq_class &lo = box.lo.back(), &hi = box.hi.back();
    if (demand.ratios && (demand.ratios->first < lo || demand.ratios->second > hi))
        return covered_part(lo, hi, demand.ratios->first, demand.ratios->second);
    if (demand.most && (!most || integer(*most) > *demand.most))
        return "not proved: at most " + demand.most->get_str() + " collisions from the box";
    if (demand.least && integer(least) < *demand.least)
        return "not proved: at least " + demand.least->get_str() + " collisions from the box";
    return "";
}

std::string Claim::text() const {
    std::string result = incoming ? "claim=incoming" : "claim=initial-conditions";
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
           (shares ? ",\"shares\":" + shares_json(*shares) : "") + "}";
}

std::string Claim::sentence() const {
    const std::string all = incoming ? "every trajectory that comes in" : "every start in the box";
    std::string text = "No bound is proved that holds for " + all;
    if (most || least > 0)
        text = "Proved: for " + all + " the dumbbell hits the floor " +
               (!most           ? "at least " + std::to_string(least)
                : *most > least ? "from " + std::to_string(least) + " to " + std::to_string(*most)
                                : std::to_string(least)) +
               (most.value_or(least) == 1 ? " time" : " times");
    if (most == least || decided == 0) return text;
    return text + "; the number is known for " +
           (decided == 1 ? "each" : "at least a share " + decimals(decided, false, share_places) + " of all");
}

std::string Claim::paragraph() const {
    std::string text = "  " + sentence() + ".\n";
    if (!shares) return text;
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
