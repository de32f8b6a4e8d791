// Files verified at the same time, and the result of each.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "verify/core/text.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_verify {

/// A file and what is demanded of it.
struct Job {
    std::string file;
    Request settings;
    Source* bytes = nullptr;  ///< of the file, where they are not read by its name
};

struct Result {
    const Job* job = nullptr;
    Failure why{Verdict::verified, 0, "", ""};  ///< if not verified
    Verified proof;                             ///< if the file is right

    /// All that the file says is certified, if only that everything is open.
    [[nodiscard]] bool is_right() const {
        return why.verdict == Verdict::verified || why.verdict == Verdict::open;
    }
};

Failure nothing_proved();  ///< of a file that is right

const char* verdict_name(Verdict verdict);  ///< VERIFIED, ...
/// 0 verified, 1 rejected, 2 unreadable, 3 open or unsupported, 4 limit
int exit_code(Verdict verdict);

/// Verifies one file; whatever is wrong is in the result.
Result examine(const Job& job);

/// Verifies all, up to `at_once` of them at the same time; `report` gets each result, in the order of the
/// jobs and on the calling thread. The results point to the jobs.
std::vector<Result> examine_all(const std::vector<Job>& jobs, unsigned at_once,
                                const std::function<void(const Result&)>& report);

}  // namespace dumbbell_verify
