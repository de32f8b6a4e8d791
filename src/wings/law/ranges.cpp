#include "law/ranges.hpp"

#include "law/bulk_rule.hpp"
#include "law/end_rule.hpp"
#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

/// A range of th in tenths of a thousand, and how far J falls there at most.
struct BulkRange {
    int lo, hi;
    double greatest_fall;
};
constexpr std::array<BulkRange, 3> bulk_ranges{{{0, 6000, 2.1}, {6000, 7000, 6.2}, {7000, 7944, 22.7}}};

constexpr int eps_parts = 4;

/// (C9): |M - p(th)| <= w(th), p = -1/3 + 0.94 th^2 - 1.035 th^4 + 2.107 th^8, w = 0.006 + 0.75 th^8, here
/// with a little to spare.
bool is_near_polynomial(const Interval& defect, const Interval& th) {
    const Interval x = sqr(th), x2 = sqr(x), x4 = sqr(x2);
    const auto thousandths = [](int k) { return Interval(k) / 1000; };
    const Interval p =
        x * thousandths(940) - x2 * thousandths(1035) + x4 * thousandths(2107) - Interval(1) / 3;
    return certainly_at_most(abs(defect - p), thousandths(6) + x4 * Interval(74) / 100);
}

/// Part i of n of [lo, hi]/10000.
Interval part_of(int lo, int hi, int i, int n) {
    const Interval result = (Interval(lo) + Interval(hi - lo) * part(i, n)) / 10'000;
    return lo == 0 && i == 0 ? Interval(0, result.hi()) : result;
}

}  // namespace

bool bulk_closes(const Parts& parts) {
    for (std::size_t k = 0; k < bulk_ranges.size(); ++k) {
        const BulkRange& range = bulk_ranges[k];
        for (int i = 0; i < parts.bulk[k]; ++i) {
            const Interval th = part_of(range.lo, range.hi, i, parts.bulk[k]);
            const Interval P = P_at(th);
            for (int e = 0; e < eps_parts; ++e) {
                const BulkBounds found = bulk_bounds(th, part(e, eps_parts) / 1000, P);
                if (!is_near_polynomial(found.defect, th) || !(found.fall.hi() <= range.greatest_fall)) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool end_closes(const Parts& parts) {
    for (int i = 0; i < parts.end; ++i) {
        const Interval d = part_of(0, 900, i, parts.end);
        if (certainly_beyond(d)) {
            continue;
        }
        const EndBounds found = end_bounds(d);
        const Interval k0 = comparison_constant();
        // (C11), with a little to spare.
        const Interval off = abs(found.surplus + Interval(1657) / 10'000);
        if (!certainly_at_most(off, (Interval(29) + 4800 * low_end(d)) / 10'000) ||
            !(found.at_zero.lo() <= k0.lo() && k0.hi() <= found.at_zero.hi())) {
            return false;
        }
    }
    return true;
}

}  // namespace dumbbell::law
