#include "collisions/leaf.hpp"

#include <type_traits>

namespace dumbbell::collisions {

/// A box that double precision closes, or shows to be open for good, needs no more. Next to a step a few
/// boxes of a piece need many bits, and all others would pay for them.
template <class I>
std::optional<Leaf> judge(Chart chart, const Box& box, const Count& upper, const Interrupted& interrupted) {
    const ChartRow& row = row_of(chart);
    if constexpr (!std::is_same_v<I, Interval>) {
        const Count most = 20'000'000'000'000LL;  // collisions: it cannot tell such counts apart
        if (upper <= most) {
            if (auto leaf = judge<Interval>(chart, box, upper, interrupted)) {
                return leaf;
            }
            if (row.is_open && row.is_open(box, as_long(upper), interrupted)) {
                return std::nullopt;
            }
        }
    }
    const auto& [in_double, in_more] = row.judges;
    const Judge judge_in = std::is_same_v<I, Interval> ? in_double : in_more;
    return judge_in(box, upper, interrupted);
}

template std::optional<Leaf> judge<Interval>(Chart, const Box&, const Count&, const Interrupted&);
template std::optional<Leaf> judge<BigInterval>(Chart, const Box&, const Count&, const Interrupted&);

}  // namespace dumbbell::collisions
