#include "verify/program/compare.hpp"

#include <algorithm>

namespace dumbbell_verify {
namespace {

constexpr Lemma lemmas[] = {{"4.1", "hybrid", "wedge", 0}, {"4.2", "dumbbell", "hybrid", 1}};

std::string said(const Lemma& lemma, const std::string& text) {
    return "lemma=" + std::string(lemma.name) + " " + text;
}
Comparison refuted(const Lemma& lemma, const std::string& reason) {
    return {false, said(lemma, reason),
            R"({"ratio":null,"excess":null,"least_excess":null,"gaps":null,"reason":")" + reason + "\"}"};
}

}  // namespace

const Lemma* find_lemma(std::string_view name) {
    for (const Lemma& lemma : lemmas)
        if (lemma.name == name) return &lemma;
    return nullptr;
}

/// Where a piece of A and one of B overlap in more than a point, both bounds must agree; those overlaps are
/// closed and cover the range, so nothing more is needed. If the range is a point, the best bounds there
/// count. Where one of the pieces is a gap, whose two bounds differ by 1, an excess by 1 is counted, not
/// refused.
Comparison compare(const Lemma& lemma, const Collisions& a, const Collisions& b) {
    mpq_class lo = std::max(a.lo, b.lo), hi = std::min(a.hi, b.hi);
    if (a.ratios) lo = std::max(lo, a.ratios->first), hi = std::min(hi, a.ratios->second);
    if (lo > hi) return refuted(lemma, "the files have no mass ratio in common");
    const bool point = lo == hi;
    const mpz_class slack = lemma.slack;
    const auto is_gap = [](const Collisions::Part& part) {
        return part.upper && *part.upper == part.lower + 1;
    };
    std::optional<mpz_class> excess, least;
    std::uint64_t gaps = 0;
    std::size_t first = 0;
    for (const Collisions::Part& p : a.parts) {
        while (first < b.parts.size() && b.parts[first].hi < p.lo) ++first;
        for (std::size_t j = first; j < b.parts.size() && b.parts[j].lo <= p.hi; ++j) {
            const Collisions::Part& other = b.parts[j];
            const mpq_class from = std::max({p.lo, other.lo, lo}), to = std::min({p.hi, other.hi, hi});
            if (from > to || (from == to && !point) || (point && !p.upper)) continue;
            const mpz_class here = p.upper ? mpz_class(*p.upper - other.lower) : mpz_class(slack + 2);
            if (!point && here == slack + 1 && (is_gap(p) || is_gap(other))) {
                ++gaps;
                continue;
            }
            if (!point && here > slack)
                return refuted(lemma, "not proved on " + to_string(from, to) +
                                          ": upper=" + (p.upper ? p.upper->get_str() : "none") +
                                          " of the first file, lower=" + other.lower.get_str() +
                                          " of the second");
            least = std::min(least.value_or(here), here);
            excess = point && excess ? std::min(*excess, here) : std::max(excess.value_or(here), here);
        }
    }
    if (!excess || *excess > slack) return refuted(lemma, "not proved at " + to_string(lo));
    const std::string e = excess->get_str(), l = least->get_str(), k = std::to_string(gaps);
    return {true,
            said(lemma, "ratio=" + to_string(lo, hi) + " excess=" + e + " least-excess=" + l + " gaps=" + k),
            R"({"ratio":{"lo":")" + to_string(lo) + R"(","hi":")" + to_string(hi) + R"("},"excess":)" + e +
                R"(,"least_excess":)" + l + R"(,"gaps":)" + k + R"(,"reason":null})"};
}

}  // namespace dumbbell_verify
