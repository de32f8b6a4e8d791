#include "collisions/leaf.hpp"

#include <type_traits>

#include "base/error.hpp"
#include "collisions/leaf_judges.hpp"

namespace dumbbell::collisions {

/// A box that double precision closes, or shows to be open for good, needs no more. Next to a step a few
/// boxes of a piece need many bits, and all others would pay for them.
template <class I>
std::optional<Leaf> judge(Chart chart, const Box& box, const Count& upper, const Interrupted& interrupted) {
    if constexpr (!std::is_same_v<I, Interval>) {
        constexpr long most = 20'000'000'000'000;  // collisions: it cannot tell such counts apart
        if (upper <= most) {
            if (auto leaf = judge<Interval>(chart, box, upper, interrupted)) {
                return leaf;
            }
            const bool turning = chart == Chart::bridge || chart == Chart::light;
            if (turning && is_open_turning(chart, box, as_long(upper), interrupted)) {
                return std::nullopt;
            }
        }
    }
    switch (chart) {
        case Chart::bridge:
        case Chart::light:
            return judge_turning<I>(chart, box, upper, interrupted);
        case Chart::wedge:
            return judge_wedge<I>(box, as_long(upper), interrupted);
        case Chart::contact:
        case Chart::departure:
        case Chart::plain_contact:
        case Chart::plain_departure:
        case Chart::again:
            return judge_full<I>(chart, box, as_long(upper), interrupted);
        case Chart::corner:
            break;
    }
    throw BrokenInvariant("unknown chart");
}

template std::optional<Leaf> judge<Interval>(Chart, const Box&, const Count&, const Interrupted&);
template std::optional<Leaf> judge<BigInterval>(Chart, const Box&, const Count&, const Interrupted&);

}  // namespace dumbbell::collisions
