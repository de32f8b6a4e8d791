#include "law/at_ratio_report.hpp"

#include <fmt/core.h>

#include "law/certificate.hpp"
#include "number/decimal.hpp"

namespace dumbbell::law {
namespace {

/// |x| for people, cut to three digits towards 0 (`up` false) or away from it.
std::string size(const Rational& x, bool up) {
    const Rational size = abs(x);
    return size == 0 ? "0" : dumbbell::to_text(up ? cut_up(size, 3) : cut_down(size, 3));
}

/// Where q lies by the step, in words.
std::string place(const AtRatio& at) {
    const Rational lo = exact_lo(at.past), hi = exact_hi(at.past);
    const std::string ratio = "the ratio beyond which the maximum is " + at.step.str();
    if (at.lower < at.upper) {
        return fmt::format("It lies at most {} of a step below or {} above {}: too near to tell.\n",
                           size(lo, true), size(hi, true), ratio);
    }
    if (lo == 0 && hi == 0) {
        return fmt::format("It is {}.\n", ratio);
    }
    const bool above = lo >= 0;
    return fmt::format("It lies {} to {} of a step {} {}.\n", size(above ? lo : hi, false),
                       size(above ? hi : lo, true), above ? "above" : "below", ratio);
}

}  // namespace

std::string verdict(const AtRatioReport& report) {
    const AtRatio& at = report.at;
    const std::string q = exact_text(at.q);
    return at.lower == at.upper
               ? fmt::format("N(q) = {} at q = {}.\n", at.lower.str(), q)
               : fmt::format("N(q) is {} or {} at q = {}.\n", at.lower.str(), at.upper.str(), q);
}

std::string to_text(const AtRatioReport& report) {
    return verdict(report) + place(report.at) + "\n" + basis_text(report.file, report.sha256);
}

Json to_json(const AtRatioReport& report) {
    const AtRatio& at = report.at;
    return Json::object({{"schema", "dumbbell-law-ratio-1"},
                         {"ratio", to_fraction(at.q)},
                         {"lower", at.lower.str()},
                         {"upper", at.upper.str()},
                         {"step", at.step.str()},
                         {"past", ends_json(Interval(at.past.lo(), at.past.hi()))},
                         {"file", report.file},
                         {"sha256", report.sha256}});
}

}  // namespace dumbbell::law
