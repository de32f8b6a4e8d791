#include "law/critical_report.hpp"

#include <fmt/core.h>

#include "law/certificate.hpp"
#include "number/decimal.hpp"

namespace dumbbell::law {
namespace {

/// The ends of an enclosure as decimals, rounded outward a little beyond the first digit in which they
/// differ.
struct Ends {
    std::string lo, hi;
};
Ends ends_of(const BigInterval& x) {
    const Rational lo = exact_lo(x), hi = exact_hi(x);
    int digits = 1;
    while (cut_down(lo, digits) == cut_down(hi, digits)) {
        ++digits;
    }
    return {dumbbell::to_text(cut_down(lo, digits + 2)), dumbbell::to_text(cut_up(hi, digits + 2))};
}

}  // namespace

std::string verdict(const CriticalByLaw& report) {
    const Ends ends = ends_of(report.q_c);
    return fmt::format("{} <= q_c({}) <= {}\n", ends.lo, report.n.str(), ends.hi);
}

std::string to_text(const CriticalByLaw& report) {
    const Rational width = exact_hi(report.q_c) - exact_lo(report.q_c);
    return verdict(report) +
           fmt::format("Width: {}. The maximum steps from {} to {} there.\n\n",
                       dumbbell::to_text(cut_up(width, 3)), Integer(report.n - 1).str(), report.n.str()) +
           basis_text(report.file, report.sha256);
}

Json to_json(const CriticalByLaw& report) {
    const Ends ends = ends_of(report.q_c);
    return Json::object({{"schema", "dumbbell-critical-law-1"},
                         {"N", report.n.str()},
                         {"lo", ends.lo},
                         {"hi", ends.hi},
                         {"file", report.file},
                         {"sha256", report.sha256}});
}

}  // namespace dumbbell::law
