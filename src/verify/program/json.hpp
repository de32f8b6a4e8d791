// The results as JSON (docs/reference/json.md has the fields).
#pragma once
#include <string>

#include "verify/program/compare.hpp"
#include "verify/program/examine.hpp"

namespace dumbbell_verify {

std::string json(const Result& result);  ///< one object

/// Of files that were taken together: what is said of all, and the object of each.
std::string json(const Result& whole, const std::vector<Result>& files);

/// Of a comparison: its result, JSON or null if a file is not verified, and the objects of both
/// files.
std::string json(const Lemma& lemma, Verdict verdict, const std::string& comparison,
                 const std::vector<Result>& files);

}  // namespace dumbbell_verify
