#include "law/ranges.hpp"

#include "law/bulk_rule.hpp"
#include "law/end_rule.hpp"
#include "law/functions.hpp"

namespace dumbbell::law {
namespace {

/// A range of th in tenths of a thousand, and what is claimed of it.
struct BulkRange {
    int lo, hi;
    double least_defect, greatest_defect, greatest_fall;
};
constexpr std::array<BulkRange, 3> bulk_ranges{
    {{0, 6000, -0.334, 0, 2.1}, {6000, 7000, -0.125, 0.085, 6.2}, {7000, 7944, -0.105, 0.47, 22.7}}};

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
            const BulkBounds found = bulk_bounds(part_of(range.lo, range.hi, i, parts.bulk[k]));
            if (!within(found.defect, range.least_defect, range.greatest_defect) ||
                !(found.fall.hi() <= range.greatest_fall)) {
                return false;
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
        if (!within(found.surplus, -0.23, -0.0885) ||
            !(found.at_zero.lo() <= k0.lo() && k0.hi() <= found.at_zero.hi())) {
            return false;
        }
    }
    return true;
}

}  // namespace dumbbell::law
