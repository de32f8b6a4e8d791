#include "verify/core/claim.hpp"

#include <algorithm>

namespace dumbbell_verify {
std::string to_string(const mpq_class& ratio) {
    return ratio.get_num().get_str() + "/" + ratio.get_den().get_str();
}
std::string to_string(const mpq_class& lo, const mpq_class& hi) {
    return to_string(lo) + ":" + to_string(hi);
}

std::string covered_part(const mpq_class& lo, const mpq_class& hi, const mpq_class& from,
                         const mpq_class& to) {
    if (hi < from || to < lo)
        return "nothing is said of the mass ratios " + to_string(from, to) + ", only of " + to_string(lo, hi);
    return "of the mass ratios " + to_string(from, to) + " only " +
           to_string(std::max(lo, from), std::min(hi, to)) + " are covered";
}

Bounds::Bounds(const std::optional<mpz_class>& u, const mpz_class& v)
    : upper(u), lower(v), pieces(1), gaps(u && *u == v + 1), open(!u || *u > v + 1) {}

void Bounds::join(const Bounds& next) {
    if (pieces == 0)
        *this = next;
    else if (next.pieces > 0) {
        upper = upper && next.upper ? std::max(upper, next.upper) : std::nullopt;
        lower = std::min(lower, next.lower);
        pieces += next.pieces;
        gaps += next.gaps;
        open += next.open;
    }
}

void Bounds::meet(const Bounds& next) {
    if (pieces == 0 || next.pieces == 0) return join(next);
    if (!upper || (next.upper && *next.upper < *upper)) upper = next.upper;
    *this = Bounds(upper, std::max(lower, next.lower));
}

void Collisions::ask(const Bounds& next) {
    const bool is_point = ratios ? ratios->first == ratios->second : lo == hi;
    is_point ? asked.meet(next) : asked.join(next);
}

void Collisions::add(const mpq_class& a, const mpq_class& b, const std::optional<mpz_class>& u,
                     const mpz_class& v) {
    const mpq_class& from = start();
    const bool proves[] = {true, u && (!most || *u <= *most), !least || v >= *least};
    for (std::size_t i = 0; i < 3; ++i)
        if (proves[i] && (reached[i] ? a <= *reached[i] : a <= from && from <= b)) reached[i] = b;
    const Bounds piece(u, v);
    join(piece);
    const mpq_class &first = ratios ? ratios->first : lo, &last = ratios ? ratios->second : hi;
    // What has no more than an end in common with a range says nothing of it that its neighbour does not.
    if (first == last || a == b ? a <= last && first <= b : a < last && first < b) ask(piece);
}

std::string Collisions::missing() const {
    const mpq_class &from = ratios ? ratios->first : lo, &to = ratios ? ratios->second : hi;
    const std::string range = (rho ? " for every Q in " : " for every mass ratio in ") + to_string(from, to);
    const auto covered = [&](std::size_t i) { return reached[i] && *reached[i] >= to; };
    if (asked.upper && *asked.upper < asked.lower) return "the bounds of the pieces exclude each other";
    if (from < lo || !covered(0)) return covered_part(lo, hi, from, to);
    if (most && !covered(1)) return "not proved: at most " + most->get_str() + " collisions" + range;
    if (rhos && !(rho && rho->first <= rhos->first && rhos->second <= rho->second))
        return "not proved for every rho in " + to_string(rhos->first, rhos->second);
    if (least && !covered(2)) return "not proved: at least " + least->get_str() + " collisions" + range;
    return "";
}

}  // namespace dumbbell_verify
