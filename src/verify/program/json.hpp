// The results as JSON (docs/reference/json.md has the fields).
#pragma once
#include <string>

#include "verify/program/examine.hpp"

namespace dumbbell_verify {

std::string json(const Result& result);  ///< one object
/// A string from 2^53 on: most readers of JSON keep numbers in doubles. Precondition: n >= 0.
std::string json_count(const mpz_class& n);

}  // namespace dumbbell_verify
