#include "verify/wings/starts/demand.hpp"

#include <cmath>

#include "verify/machine/decimals.hpp"
#include "verify/machine/integer.hpp"
#include "verify/wings/starts/mean.hpp"

namespace dumbbell_verify::starts {

Box demanded_box(Box box, const Numbers& numbers, const std::optional<Range>& ratios) {
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
        const auto side = numbers.find(axis_names[i]);
        if (side != numbers.end()) std::tie(box.lo[i], box.hi[i]) = side->second;
    }
    if (ratios) std::tie(box.lo.back(), box.hi.back()) = *ratios;
    return box;
}

mpq_class share_in(const Box& leaf, const Box& asked, const Box& file) {
    mpq_class share = 1;
    for (std::size_t i = 0; i < axis_names.size(); ++i) {
        const mpq_class &lo = asked.lo[i], &hi = asked.hi[i], from = std::max(lo, leaf.lo[i]),
                        to = std::min(hi, leaf.hi[i]);
        const bool holds = lo < hi ? from < to : from <= to && (lo < leaf.hi[i] || leaf.hi[i] == file.hi[i]);
        if (!holds) return 0;
        if (lo < hi) share *= (to - from) / (hi - lo);
    }
    return share;
}

std::string missing(const Claim& claim, const Collisions& demand, const Numbers& numbers) {
    const Box &asked = claim.asked_box, &box = claim.box;
    for (std::size_t i = 0; i < axis_names.size(); ++i)
        if (asked.lo[i] < box.lo[i] || asked.hi[i] > box.hi[i])
            return "nothing is said of all " + header_name(i) + " in " + to_string(asked.lo[i], asked.hi[i]) +
                   ", only of " + to_string(box.lo[i], box.hi[i]);
    const Known& known = claim.asked;
    if (demand.most && (!known.most || integer(*known.most) > *demand.most))
        return "not proved: at most " + demand.most->get_str() + " collisions from the box";
    if (demand.least && integer(known.least) < *demand.least)
        return "not proved: at least " + demand.least->get_str() + " collisions from the box";
    const auto decided = numbers.find("decided");
    if (decided != numbers.end() && known.decided < decided->second.first)
        return "not proved: the number of collisions for a share " + to_string(decided->second.first) +
               " of the box, only for " + decimals(known.decided, false, share_places);
    if (!claim.shares || !claim.incoming) return "";
    const Shares& shares = *claim.shares;
    const Interval<double> mean = means(box.lo.back()).all;
    const bool differ = (std::isfinite(mean.hi) && shares.least_mean > mpq_class(mean.hi)) ||
                        (shares.open == 0 && shares.most_mean < mpq_class(mean.lo));
    return differ ? "the mean number of collisions is not that of Theorem 6" : "";
}

}  // namespace dumbbell_verify::starts
