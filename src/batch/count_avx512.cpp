#include "batch/backends.hpp"
#include "batch/lower_count.hpp"
#include "batch/pack_avx512.hpp"

namespace dumbbell::batch {

void count_at_most_avx512(const Query* queries, Answer* answers, long size, Stop stop) {
    LowerCount<Pack8>(queries, answers, size).run(stop);
}

}  // namespace dumbbell::batch
