#include "flight/batch/backends.hpp"
#include "flight/batch/count_lanes.hpp"
#include "flight/batch/lower_bounce.hpp"
#include "flight/batch/pack_avx512.hpp"
#include "flight/batch/upper_bounce.hpp"

namespace dumbbell::flight::batch {

void count_at_most_avx512(const Query* queries, Answer* answers, long size, Stop stop) {
    CountLanes<Pack8, 6, Lower>(queries, answers, size).run(stop);
}

void count_at_least_avx512(const Query* queries, Answer* answers, long size, Stop stop) {
    CountLanes<Pack8, 6, Upper>(queries, answers, size).run(stop);
}

}  // namespace dumbbell::flight::batch
