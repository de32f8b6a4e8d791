#include "flight/paper_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace dumbbell::flight {
namespace {

/// Whether q <= cot^2(pi / 2m), for m >= 2.
bool reaches(const Rational& q, long m) {
    if (m == 2 || m == 3) {
        return q <= (m == 2 ? 1 : 3);
    }
    for (int bits = 128; bits <= (1 << 16); bits *= 2) {
        const PrecisionScope scope(bits);
        const auto at = sin_cos(half_pi<BigInterval>() / BigInterval(static_cast<double>(m)));
        const BigInterval limit = sqr(at.cos / at.sin);
        const BigInterval ratio = enclose<BigInterval>(q);
        if (certainly_less(ratio, limit)) {
            return true;
        }
        if (certainly_less(limit, ratio)) {
            return false;
        }
    }
    throw BrokenInvariant("paper bound: undecided at 65536 bits");
}

}  // namespace

Rational paper_bound_limit() { return Rational(3 * pow(Integer(10), 31)); }

long paper_bound(const Rational& q) {
    require(q >= 1 && q <= paper_bound_limit(), "paper bound: 1 <= q <= 3e31");
    // atan(1/sqrt q) ~ 1/sqrt q: a guess to start from.
    long m =
        std::max(2L, std::lround(std::numbers::pi / 2 / std::atan(1 / std::sqrt(q.convert_to<double>()))));
    while (!reaches(q, m)) {
        ++m;
    }
    while (m > 2 && reaches(q, m - 1)) {
        --m;
    }
    return m + 1;
}

}  // namespace dumbbell::flight
