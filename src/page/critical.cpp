#include <fmt/format.h>

#include "page/file.hpp"

namespace dumbbell {

nlohmann::ordered_json file_json(const CriticalTable& table, const BoxBudget& /*no boxes*/) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const CriticalTableRow& row : table.rows) {
        rows.push_back({{"n", row.n},
                        {"q_c", row.q_c},
                        {"radius", row.radius},
                        {"bits", row.bits},
                        {"orbit", row.orbit},
                        {"flight", row.flight}});
    }
    const long first = table.rows.front().n;
    const long last = table.rows.back().n;
    return {
        {"claim", "critical-ratios"},
        {"again", fmt::format("dumbbell critical {} --digits {}",
                              first == last ? fmt::format("{}", first) : fmt::format("{}:{}", first, last),
                              table.digits())},
        {"rows", std::move(rows)}};
}

}  // namespace dumbbell
