#include "cli/terminal/common.hpp"

#include <algorithm>
#include <thread>

#include "number/ratio_argument.hpp"

namespace dumbbell::cli {

int jobs_of(const Given& given) {
    return given.has("--jobs") ? static_cast<int>(given.number("--jobs"))
                               : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::optional<std::chrono::duration<double>> budget_of(const Given& given) {
    return given.has("--budget") ? std::optional(parse_duration(given.text("--budget"))) : std::nullopt;
}

Verbosity verbosity_of(const Given& given) {
    return given.has("--quiet") ? Verbosity::quiet : Verbosity::normal;
}

}  // namespace dumbbell::cli
