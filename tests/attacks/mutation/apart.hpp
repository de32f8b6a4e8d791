// Work in processes of its own, so that a crash or an endless loop costs one item and is counted.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace dumbbell_mutation {

struct Ended {
    std::string result;  ///< what the work returned, on one line
    int signal = 0;      ///< that ended the process instead; SIGPROF: the time was up
};

/// work(0), ..., work(n - 1), each in one of `jobs` processes, with `seconds` of processor time each. Throws
/// std::runtime_error if processes cannot be made. Precondition: this process has one thread.
[[nodiscard]] std::vector<Ended> run_apart(std::size_t n, unsigned jobs, int seconds,
                                           const std::function<std::string(std::size_t)>& work);

}  // namespace dumbbell_mutation
