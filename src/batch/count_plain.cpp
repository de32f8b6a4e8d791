#include "batch/backends.hpp"
#include "batch/lower_count.hpp"

namespace dumbbell::batch {

void count_at_most_plain(const Query* queries, Answer* answers, long size, Stop stop) {
    LowerCount<double>(queries, answers, size).run(stop);
}

}  // namespace dumbbell::batch
