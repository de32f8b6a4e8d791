// What is proved, in English.
#pragma once
#include <string>

#include "verify/program/examine.hpp"

namespace dumbbell_verify {

/// Of a file that is right: one sentence about numbers of collisions, of what was
/// demanded or else of all mass ratios in question; the paragraph of a file about something else. In whole
/// lines that begin with two spaces.
std::string sentence(const Result& result);

}  // namespace dumbbell_verify
