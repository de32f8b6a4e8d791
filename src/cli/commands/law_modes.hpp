#pragma once

#include <string>

#include "cli/options/given.hpp"

/// What the law of N(q) is used for by the commands; each returns its exit code.
namespace dumbbell::cli {

/// What a verified staircase says as a whole.
int law_of_staircase(const Given& given, const std::string& file);

/// The law for every mass ratio, by its verified certificate.
int law_for_all(const Given& given, const std::string& file);
/// --prove.
int prove_law_for_all(const Given& given);
/// --ratio, by the certificate FILE.
int law_at_one_ratio(const Given& given);

/// `certify --by law`.
int certify_by_law(const Given& given);
/// `critical --by law`.
int critical_by_law(const Given& given);

}  // namespace dumbbell::cli
