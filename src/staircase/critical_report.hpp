#pragma once

#include <optional>
#include <string>
#include <vector>

#include "staircase/critical_range.hpp"
#include "words/json.hpp"

namespace dumbbell::staircase {

/// What `critical` tells its user.
struct CriticalReport {
    CriticalRequest request;
    std::vector<CriticalRow> rows;  ///< of a range up to the last that is finished, or the first
    double seconds = 0;
    std::optional<std::string> out;
};

/// For people and in JSON: leaves out the rows behind the last finished one, but for the first: a range may
/// be far too long for its budget.
void leave_out_unreached(CriticalReport& report);

/// One ratio in words, several as a table; below it what was proved, and what that rests on.
[[nodiscard]] std::string to_text(const CriticalReport& report);
/// The ratios alone, a line each.
[[nodiscard]] std::string verdict(const CriticalReport& report);
[[nodiscard]] Json to_json(const CriticalReport& report);

/// The table as a file: tab-separated, remarks begin with #, and nothing in it depends on the run.
[[nodiscard]] std::string to_tsv(const CriticalReport& report);

}  // namespace dumbbell::staircase
