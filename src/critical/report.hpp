#pragma once

#include <optional>
#include <string>
#include <vector>

#include "critical/range.hpp"
#include "words/json.hpp"

namespace dumbbell::critical {

/// What `critical` tells its user.
struct Report {
    Request request;
    std::vector<Row> rows;  ///< of a range up to the last that is finished, or the first
    double seconds = 0;
    std::optional<std::string> out;
};

/// How many are not enclosed.
[[nodiscard]] long open_in(const Report& report);

/// For people and in JSON: leaves out the rows behind the last finished one, but for the first: a range may
/// be far too long for its budget.
void leave_out_unreached(Report& report);

/// One ratio in words, several as a table; below it what was proved, and what that rests on.
[[nodiscard]] std::string to_text(const Report& report);
/// The ratios alone, a line each.
[[nodiscard]] std::string verdict(const Report& report);
[[nodiscard]] Json to_json(const Report& report);

/// The table as a file: tab-separated, remarks begin with #, and nothing in it depends on the run.
[[nodiscard]] std::string to_tsv(const Report& report);

}  // namespace dumbbell::critical
