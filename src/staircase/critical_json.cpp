#include <algorithm>

#include "flight/extremal_orbit.hpp"
#include "number/decimal.hpp"
#include "staircase/critical_number.hpp"
#include "staircase/critical_report.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

/// Of the ends, beyond those of the number.
constexpr int more_digits = 20;

nlohmann::ordered_json decided_json(const Decided& decided) {
    return {{"ratio", to_fraction(decided.q)},
            {"expected", decided.expected},
            {"upper", json_or_null(decided.upper)},
            {"lower", decided.lower},
            {"bits", decided.bits}};
}

nlohmann::ordered_json row_json(const CriticalRow& row, const CriticalReport& report) {
    nlohmann::ordered_json json{{"n", row.n},
                                {"orbit", orbit_name(row.n)},
                                {"flight", tangent_flight(row.n).flight},
                                {"status", row.ratio ? "proved" : "open"}};
    if (row.ratio) {
        const CriticalNumber p = critical_number(*row.ratio, report.request.digits);
        const int ends = report.request.digits + more_digits;
        json["q_c"] = p.value;
        json["radius"] = p.radius;
        json["exact"] = p.exact;
        json["lo"] = to_text(without_zeros(cut_down(row.ratio->q_lo, ends)));
        json["hi"] = to_text(without_zeros(cut_up(row.ratio->q_hi, ends)));
        json["bits"] = row.ratio->bits;
    }
    if (row.confirmation) {
        json["confirmed"] = row.confirmation->holds();
        json["below"] = decided_json(row.confirmation->below);
        json["above"] = decided_json(row.confirmation->above);
    }
    return json;
}

}  // namespace

nlohmann::ordered_json to_json(const CriticalReport& report) {
    nlohmann::ordered_json ratios = nlohmann::ordered_json::array();
    for (const CriticalRow& row : report.rows) {
        ratios.push_back(row_json(row, report));
    }
    nlohmann::ordered_json json{{"schema", "dumbbell-critical-1"},
                                {"method", "interval Newton: exactly one tangency in the bracket"},
                                {"rests_on", "proofs/theorem.md, theorem 2"},
                                {"digits", report.request.digits},
                                {"confirm", nullptr},
                                {"jobs", report.request.jobs},
                                {"ratios", std::move(ratios)},
                                {"open", std::count_if(report.rows.begin(), report.rows.end(),
                                                       [](const CriticalRow& row) { return !row.ratio; })},
                                {"seconds", report.seconds},
                                {"out", json_or_null(report.out)}};
    if (report.request.confirm) {
        json["confirm"] = to_fraction(*report.request.confirm);
    }
    return json;
}

}  // namespace dumbbell
