#include "verify/core/claim.hpp"

#include <algorithm>

namespace dumbbell_verify {
std::string to_string(const mpq_class& ratio) {
    return ratio.get_num().get_str() + "/" + ratio.get_den().get_str();
}
std::string to_string(const mpq_class& lo, const mpq_class& hi) {
    return to_string(lo) + ":" + to_string(hi);
}

Bounds::Bounds(const std::optional<mpz_class>& u, const mpz_class& v, int l)
    : upper(u), lower(v), pieces(1), gaps(u && *u > v && *u <= v + l), open(!u || *u > v + l), leap(l) {}

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
    *this = Bounds(upper, std::max(lower, next.lower), leap);
}

void Known::join(const Known& next) {
    if (!next.first) return;
    if (!last) return void(*this = next);
    widest = std::max({widest, next.widest, mpq_class((*next.first - *last) / *last)});
    gaps += next.gaps;
    if (*last < *next.first) ++gaps;
    last = next.last;
}

Known Collisions::whole() const {
    const mpq_class to = std::min(question().second, hi);
    Known all{start(), start(), 0};
    all.join(known);
    all.join({to, to, 0});
    return all;
}
bool Collisions::is_known_but_in_gaps() const {
    const auto [from, to] = question();
    if (from == to) return asked.upper == asked.lower;
    const Known all = whole();
    return asked.open == 0 && (!gap || all.widest <= *gap) && (!gaps_at_most || all.gaps <= *gaps_at_most);
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
    const Bounds piece(u, v, leap);
    join(piece);
    const auto [first, last] = question();
    if (u && *u == v && a < b && a < last && first < b)
        known.join({std::max(a, first), std::min(b, last), 0});
    // What has no more than an end in common with a range says nothing of it that its neighbour does not.
    if (first == last || a == b ? a <= last && first <= b : a < last && first < b) ask(piece);
}

std::string Collisions::missing() const {
    const auto [from, to] = question();
    const std::string range = (rho ? " for every Q in " : " for every mass ratio in ") + to_string(from, to);
    const auto covered = [this, &to = to](std::size_t i) { return reached[i] && *reached[i] >= to; };
    if (from < lo || !covered(0)) {
        const std::string which = (rho ? "Q in " : "the mass ratios ") + to_string(from, to);
        if (hi < from || to < lo) return "nothing is said of " + which + ", only of " + to_string(lo, hi);
        return "of " + which + " only " + to_string(std::max(lo, from), std::min(hi, to)) + " are covered";
    }
    if (most && !covered(1)) return "not proved: at most " + most->get_str() + " collisions" + range;
    if (rhos && !(rho && rho->first <= rhos->first && rhos->second <= rho->second))
        return "not proved for every rho in " + to_string(rhos->first, rhos->second);
    if (least && !covered(2)) return "not proved: at least " + least->get_str() + " collisions" + range;
    if ((gap || gaps_at_most) && !is_known_but_in_gaps())
        return "not proved: the greatest number itself" + range + ", but in gaps" +
               (gap ? " of relative width " + to_string(*gap) : "") +
               (gaps_at_most ? ", at most " + gaps_at_most->get_str() : "");
    return "";
}

}  // namespace dumbbell_verify
