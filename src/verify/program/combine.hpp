// `--combine`: whether parts that were verified one by one are the whole file.
#pragma once
#include "verify/program/part_lines.hpp"

namespace dumbbell_verify {

/// The number of different parts. Returns only if each line is, letter by letter, what --shards prints of
/// these pieces of this file, each part was checked with the precision that the settings demand, and together
/// the parts have every piece; else throws a Failure. `proof` is of the file as a whole, read without
/// checking any leaf, and has kept all pieces. Work: O(log n) for each line; memory: O(n) and two numbers for
/// each part.
///
/// That a line was printed by a run of --shards that checked its pieces is not seen from it: the lines are
/// trusted.
std::uint64_t combine(PartLines& lines, const Proof& proof, const Settings& settings);

}  // namespace dumbbell_verify
