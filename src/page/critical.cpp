#include <fmt/core.h>

#include "page/file.hpp"

namespace dumbbell::page {

Json file_json(const staircase::CriticalTable& table, const BoxBudget& /*no boxes*/) {
    Json rows = Json::array();
    for (const staircase::CriticalTableRow& row : table.rows) {
        rows.add(Json::object({{"n", row.n},
                               {"q_c", row.q_c},
                               {"radius", row.radius},
                               {"bits", row.bits},
                               {"orbit", row.orbit},
                               {"flight", row.flight}}));
    }
    const long first = table.rows.front().n;
    const long last = table.rows.back().n;
    return Json::object(
        {{"claim", "critical-ratios"},
         {"again", fmt::format("dumbbell critical {} --digits {}",
                               first == last ? fmt::format("{}", first) : fmt::format("{}:{}", first, last),
                               table.digits())},
         {"rows", rows}});
}

}  // namespace dumbbell::page
