// In this file alone products and sums are fused: nothing here has to be the same on every machine.
#include "flight/batch/pack_avx512.hpp"
#include "plain_packs.hpp"
#include "plain_step.hpp"

namespace dumbbell_bench {

using dumbbell::flight::batch::Answer;
using dumbbell::flight::batch::CountLanes;
using dumbbell::flight::batch::Pack8;
using dumbbell::flight::batch::Query;
using dumbbell::flight::batch::Stop;

namespace {

Stop never_stop() {
    return {[](const void*) { return false; }, nullptr};
}

}  // namespace

void plain_one_pack(const Query* queries, Answer* answers, long size) {
    CountLanes<Pack8, 1, Plain>(queries, answers, size).run(never_stop());
}

void plain_six_packs(const Query* queries, Answer* answers, long size) {
    CountLanes<Pack8, 6, Plain>(queries, answers, size).run(never_stop());
}

}  // namespace dumbbell_bench
