// What is demanded of files about starts, besides mass ratios and bounds.
#pragma once
#include "verify/wings/starts/claim.hpp"

namespace dumbbell_verify::starts {

/// The box in question: the file's, cut down to the sides that are demanded.
Box demanded_box(Box box, const Numbers& numbers, const std::optional<Range>& ratios);

/// The share of the box in question that lies in a leaf. Where a side of it is one number, the leaves of the
/// file's box go up to their upper ends without them, but for the last ones: each number is in one leaf.
mpq_class share_in(const Box& leaf, const Box& asked, const Box& file);

/// What is demanded of the claim and not proved by it, or why its shares cannot be true; empty: nothing.
std::string missing(const Claim& claim, const Collisions& demand, const Numbers& numbers);

}  // namespace dumbbell_verify::starts
