#include <algorithm>

#include "collisions/critical_long.hpp"
#include "flight/extremal_orbit.hpp"
#include "number/decimal.hpp"
#include "staircase/critical_number.hpp"
#include "staircase/critical_report.hpp"

namespace dumbbell::staircase {
namespace {

/// Of the ends, beyond those of the number.
constexpr int more_digits = 20;

Json decided_json(const Decided& decided) {
    return Json::object({{"ratio", to_fraction(decided.q)},
                         {"expected", decided.expected},
                         {"upper", decided.upper},
                         {"lower", decided.lower},
                         {"bits", decided.bits}});
}

Json row_json(const CriticalRow& row, const CriticalReport& report) {
    Json json = Json::object({{"n", row.n},
                              {"orbit", orbit_name(row.n)},
                              {"flight", flight::tangent_flight(row.n).flight},
                              {"status", row.ratio ? "proved" : "open"}});
    if (row.ratio) {
        const CriticalNumber p = critical_number(*row.ratio, report.request.digits);
        const int ends = report.request.digits + more_digits;
        json.add("q_c", p.value);
        json.add("radius", p.radius);
        json.add("exact", p.exact);
        json.add("lo", to_text(without_zeros(cut_down(row.ratio->q_lo, ends))));
        json.add("hi", to_text(without_zeros(cut_up(row.ratio->q_hi, ends))));
        json.add("bits", row.ratio->bits);
    }
    if (row.confirmation) {
        json.add("confirmed", row.confirmation->holds());
        json.add("below", decided_json(row.confirmation->below));
        json.add("above", decided_json(row.confirmation->above));
    }
    return json;
}

std::string method(long first, long last) {
    const std::string newton = "interval Newton: exactly one tangency in the bracket";
    const std::string counts = "numbers of collisions at both ends, by macro steps (L42)";
    if (collisions::is_long(first) || !collisions::is_long(last)) {
        return collisions::is_long(first) ? counts : newton;
    }
    return newton + "; from N = " + std::to_string(collisions::first_long) + " on " + counts;
}

}  // namespace

Json to_json(const CriticalReport& report) {
    Json ratios = Json::array();
    for (const CriticalRow& row : report.rows) {
        ratios.add(row_json(row, report));
    }
    return Json::object(
        {{"schema", "dumbbell-critical-1"},
         {"method", method(report.request.first, report.request.last)},
         {"rests_on", "proofs/theorem.md, theorem 2"},
         {"digits", report.request.digits},
         {"confirm", report.request.confirm ? Json(to_fraction(*report.request.confirm)) : Json()},
         {"jobs", report.request.jobs},
         {"ratios", ratios},
         {"open", std::count_if(report.rows.begin(), report.rows.end(),
                                [](const CriticalRow& row) { return !row.ratio; })},
         {"seconds", report.seconds},
         {"out", report.out}});
}

}  // namespace dumbbell::staircase
