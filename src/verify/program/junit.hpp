// JUnit XML, as test reporters read it: the Ant schema, which Jenkins, GitLab and others accept.
#pragma once
#include <ctime>
#include <string>
#include <vector>

#include "verify/core/text.hpp"

namespace dumbbell_verify {

/// One thing that was checked.
struct TestCase {
    std::string name;
    Verdict verdict;
    std::string reason;  ///< if not verified
    std::string output;  ///< its line
    double seconds = 0;
};

/// `rejected` is a failure, any other verdict but `verified` an error. The times are wall-clock.
std::string junit(const std::vector<TestCase>& cases, std::time_t started, double seconds);

}  // namespace dumbbell_verify
