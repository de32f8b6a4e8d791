// `--together`: several files that prove one claim.
#pragma once
#include <vector>

#include "verify/program/examine.hpp"

namespace dumbbell_verify {

/// What is said of all files, which were examined with Settings::together and with the demand of `asked`:
/// the same as of one file with the pieces of all in ascending order. Rejected if one of them does not begin
/// where another one ended, in whatever order they are given. If a file is not verified, the worst of them
/// says why. The result points to `asked`; it has no digest and no leaves.
Result together(const Job& asked, const std::vector<Result>& files);

/// The pieces of a file that begins where those of `all` end, and was asked the same.
void append(Collisions& all, const Collisions& next);

}  // namespace dumbbell_verify
