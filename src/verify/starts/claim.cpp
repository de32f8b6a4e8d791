#include "verify/starts/claim.hpp"

namespace dumbbell_verify {
namespace {

/// x in [0, 1] with twelve decimals, rounded down.
std::string decimal(const mpq_class& x) {
    if (x >= 1) return "1";
    const mpz_class scaled = x.get_num() * 1'000'000'000'000 / x.get_den();
    const std::string digits = scaled.get_str();
    return "0." + std::string(12 - digits.size(), '0') + digits;
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
    std::string result = "claim=initial-conditions";
    for (std::size_t i = 0; i < initial_axes.size(); ++i)
        result += " " + header_name(i) + "=" + to_string(box.lo[i], box.hi[i]);
    return result + " collisions=" + std::to_string(least) + ":" + (most ? std::to_string(*most) : "none") +
           " decided=" + decimal(decided);
}

std::string Initial::json() const {
    std::string result = "{\"kind\":\"initial-conditions\",\"box\":{";
    for (std::size_t i = 0; i < initial_axes.size(); ++i)
        result += (i > 0 ? ",\"" : "\"") + header_name(i) + "\":{\"lo\":\"" + to_string(box.lo[i]) +
                  "\",\"hi\":\"" + to_string(box.hi[i]) + "\"}";
    return result + "},\"least\":" + std::to_string(least) +
           ",\"most\":" + (most ? std::to_string(*most) : "null") + ",\"decided\":\"" + to_string(decided) +
           "\"}";
}

}  // namespace dumbbell_verify
