#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "base/observer.hpp"
#include "critical/bodies.hpp"
#include "critical/enclose.hpp"

namespace dumbbell::critical {

struct Request {
    long first = 3;  ///< q_c(first), ..., q_c(last); 3 <= first <= last
    long last = 3;
    std::optional<Bodies> bodies;  ///< whose steps they are instead; of rods all that are found
    int digits = 15;
    int jobs = 1;
    std::optional<std::chrono::duration<double>> budget;
    Observer* observer = &nobody;  ///< told of the ratios that are finished; of a single one, of its flights

    [[nodiscard]] long size() const { return last - first + 1; }
};

/// One row per n, in order; the rows do not depend on the number of jobs. Of rods one per fall of N, from the
/// lightest on, and one more without a ratio if not all were enclosed. Throws BrokenInvariant if the
/// arithmetic of a thread is not sound.
[[nodiscard]] std::vector<Row> enclose_ratios(const Request& request);

}  // namespace dumbbell::critical
