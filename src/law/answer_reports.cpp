#include "law/answer_reports.hpp"

#include <fmt/core.h>

#include "base/printable.hpp"
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

std::string verdict(const CertifiedReport& report) { return verdict(report.answer); }

std::string to_text(const CertifiedReport& report) {
    std::string text = to_text(report.answer);
    if (report.out) {
        const std::string law = report.law ? fmt::format("--law {} ", shell_file(*report.law)) : "";
        text += fmt::format("Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {}{}\n",
                            one_line(*report.out), *report.sha256, law, shell_file(*report.out));
    }
    return text;
}

Json to_json(const CertifiedReport& report) {
    const AtRatioReport& answer = report.answer;
    return Json::object({{"schema", "dumbbell-certify-law-1"},
                         {"ratio", to_fraction(answer.at.q)},
                         {"lower", answer.at.lower.str()},
                         {"upper", answer.at.upper.str()},
                         {"law", Json::object({{"file", answer.file}, {"sha256", answer.sha256}})},
                         {"out", report.out},
                         {"sha256", report.sha256}});
}

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
