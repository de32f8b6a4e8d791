#include "flight/batch/backends.hpp"
#include "flight/batch/count_lanes.hpp"
#include "flight/batch/lower_step.hpp"
#include "flight/batch/pack_plain.hpp"
#include "flight/batch/upper_step.hpp"

namespace dumbbell::flight::batch {

void count_at_most_plain(const Query* queries, Answer* answers, long size, Stop stop) {
    CountLanes<Pack2, 4, Lower>(queries, answers, size).run(stop);
}

void count_at_least_plain(const Query* queries, Answer* answers, long size, Stop stop) {
    CountLanes<Pack2, 4, Upper>(queries, answers, size).run(stop);
}

}  // namespace dumbbell::flight::batch
