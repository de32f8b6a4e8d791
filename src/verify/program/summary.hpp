// Results, in lines for readers and scripts.
#pragma once
#include <string>
#include <vector>

#include "verify/program/examine.hpp"

namespace dumbbell_verify {

/// x >= 0 with three digits, rounded up: `9.01e-7`; 0 is `0`.
std::string three_digits(mpq_class x);
std::string claim_text(const Verified& proof);  ///< what a verified file proves: `scene=S ratio=LO:HI ...`
/// ` not-demanded=ratio,max`: what was left out of a claim that was demanded; empty if nothing was.
std::string left_out(const Result& result);
std::string result_text(const Result& result);   ///< behind the verdict: claim, SHA-256, demand; or reason
std::string verdict_line(const Result& result);  ///< `s VERIFIED ...`

/// Of one file alone: its name, what is proved in English, what its lines cover if `leaves`, the verdict.
std::string block(const Result& result, bool leaves);
/// Behind several: `c files=3 verified=2 rejected=1 ... exit=1`.
std::string summary_line(const std::vector<Result>& results);

/// The verdict of all: the worst.
Verdict worst(const std::vector<Result>& results);

}  // namespace dumbbell_verify
