#pragma once

#include "flight/batch/query.hpp"

/// The kernel, each time compiled for other instructions, in a translation unit of its own (pack.hpp).
namespace dumbbell::flight::batch {

void count_at_most_portable(const Query* queries, Answer* answers, long size, Stop stop);
void count_at_least_portable(const Query* queries, Answer* answers, long size, Stop stop);
void count_at_most_avx2(const Query* queries, Answer* answers, long size, Stop stop);
void count_at_least_avx2(const Query* queries, Answer* answers, long size, Stop stop);
void count_at_most_avx512(const Query* queries, Answer* answers, long size, Stop stop);
void count_at_least_avx512(const Query* queries, Answer* answers, long size, Stop stop);

}  // namespace dumbbell::flight::batch
