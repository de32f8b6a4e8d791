#pragma once

#include "flight/batch/query.hpp"

/// The plain bounce for eight rays at once (plain_step.hpp), in AVX-512: the kernel's steps without what
/// they prove, a limit of this way to do it. One pack at a time waits for its own results; six packs in turn
/// keep it busy.
namespace dumbbell_bench {

void plain_one_pack(const dumbbell::flight::batch::Query* queries, dumbbell::flight::batch::Answer* answers,
                    long size);
void plain_six_packs(const dumbbell::flight::batch::Query* queries, dumbbell::flight::batch::Answer* answers,
                     long size);

}  // namespace dumbbell_bench
