#include "collisions/leaf.hpp"

#include <type_traits>

#include "base/error.hpp"
#include "collisions/leaf_judges.hpp"
#include "flight/batch/query.hpp"

namespace dumbbell::collisions {
namespace {

/// A box that double precision closes needs no more. Next to a step a few boxes of a piece need many bits,
/// and all others would pay for them.
template <class I>
std::optional<Leaf> judge_one(Chart chart, const Box& box, const Count& upper,
                              const Interrupted& interrupted) {
    if constexpr (!std::is_same_v<I, Interval>) {
        constexpr long most = 20'000'000'000'000;  // collisions: it cannot tell such counts apart
        if (upper <= most) {
            if (auto leaf = judge_one<Interval>(chart, box, upper, interrupted)) {
                return leaf;
            }
        }
    }
    switch (chart) {
        case Chart::bridge:
        case Chart::light:
            return judge_turning<I>(chart, box, upper, interrupted);
        case Chart::wedge:
            return judge_wedge<I>(box, upper, interrupted);
        default:
            return judge_full<I>(chart, box, upper, interrupted);
    }
}

}  // namespace

template <class I>
void judge(Chart chart, std::span<const Box> boxes, const Count& upper,
           std::span<std::optional<Leaf>> results, const Interrupted& interrupted) {
    require(boxes.size() == results.size(), "judge: as many results as boxes");
    const bool turning = chart == Chart::bridge || chart == Chart::light;
    std::vector<BoxJudgement> verdicts(boxes.size(), BoxJudgement::unsure);
    if (turning && upper <= flight::batch::most_worth_a_batch) {
        verdicts = judge_turning_together(chart, boxes, upper, results, interrupted);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (verdicts[i] == BoxJudgement::unsure) {
            results[i] = judge_one<I>(chart, boxes[i], upper, interrupted);
        }
    }
}

template void judge<Interval>(Chart, std::span<const Box>, const Count&, std::span<std::optional<Leaf>>,
                              const Interrupted&);
template void judge<BigInterval>(Chart, std::span<const Box>, const Count&, std::span<std::optional<Leaf>>,
                                 const Interrupted&);

}  // namespace dumbbell::collisions
