// The options of a verification in parts: --shards and --combine.
#pragma once
#include "verify/program/examine.hpp"
#include "verify/program/words.hpp"

namespace dumbbell_verify {

/// Puts the present option into the job if it is --shards or --combine; false if it is another. Throws
/// std::invalid_argument.
bool part_option(Words& words, Job& job);

}  // namespace dumbbell_verify
