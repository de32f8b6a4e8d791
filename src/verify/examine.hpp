// Files verified beside each other, and what came out of each.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "certificate.hpp"

namespace dumbbell_verify {

/// A file and what is demanded of it.
struct Job {
    std::string file;
    Settings settings;
};

struct Result {
    const Job* job = nullptr;
    Failure why{Verdict::verified, 0, "", ""};  ///< if not verified
    Proof proof;                                ///< if verified
    double seconds = 0;
};

const char* verdict_name(Verdict verdict);  ///< VERIFIED, ...
int exit_code(Verdict verdict);             ///< 0 verified, 1 rejected, 2 unreadable, 3 unsupported, 4 limit

/// Verifies one file; whatever is wrong is in the result.
Result examine(const Job& job);

/// Verifies all, up to `beside` at the same time; `report` gets each result, in the order of the jobs and on
/// the calling thread. The results point to the jobs.
std::vector<Result> examine_all(const std::vector<Job>& jobs, unsigned beside,
                                const std::function<void(const Result&)>& report);

}  // namespace dumbbell_verify
