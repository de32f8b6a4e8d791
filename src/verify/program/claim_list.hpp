// `--claims`: a list of certificates, each with the claim that it must prove.
#pragma once
#include "verify/program/examine.hpp"

namespace dumbbell_verify {

/// The rows of the list: a certificate, a tab, the options that state its claim; then whatever follows
/// another tab. Empty lines and lines that begin with # are remarks. Names are relative to the list's folder.
/// What the options do not say is as in `settings`. Throws std::invalid_argument naming the row if one states
/// no claim, or if there is none.
std::vector<Job> read_claims(const std::string& path, const Request& settings);

}  // namespace dumbbell_verify
