#include "law/answer_report.hpp"

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

/// How far q is from the step, in words.
std::string precision(const AtRatio& at) {
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
std::pair<std::string, std::string> ends_of(const BigInterval& x) {
    const Rational lo = exact_lo(x), hi = exact_hi(x);
    int digits = 1;
    while (cut_down(lo, digits) == cut_down(hi, digits)) {
        ++digits;
    }
    return {dumbbell::to_text(cut_down(lo, digits + 2)), dumbbell::to_text(cut_up(hi, digits + 2))};
}

std::string sentence(const AtRatio& at) {
    const std::string q = exact_text(at.q);
    return at.lower == at.upper
               ? fmt::format("N(q) = {} at q = {}.\n", at.lower.str(), q)
               : fmt::format("N(q) is {} or {} at q = {}.\n", at.lower.str(), at.upper.str(), q);
}
std::string sentence(const CriticalRatio& ratio) {
    const auto [lo, hi] = ends_of(ratio.q_c);
    return fmt::format("{} <= q_c({}) <= {}\n", lo, ratio.n.str(), hi);
}

std::string precision(const CriticalRatio& ratio) {
    const Rational width = exact_hi(ratio.q_c) - exact_lo(ratio.q_c);
    return fmt::format("Width: {}. The maximum steps from {} to {} there.\n",
                       dumbbell::to_text(cut_up(width, 3)), Integer(ratio.n - 1).str(), ratio.n.str());
}

Json fields(const AtRatio& at) {
    return Json::object({{"schema", "dumbbell-law-ratio-1"},
                         {"ratio", to_fraction(at.q)},
                         {"lower", Count(at.lower)},
                         {"upper", Count(at.upper)},
                         {"step", Count(at.step)},
                         {"past", ends_json(Interval(at.past.lo(), at.past.hi()))}});
}
Json fields(const CriticalRatio& ratio) {
    const auto [lo, hi] = ends_of(ratio.q_c);
    return Json::object({{"schema", "dumbbell-law-count-1"}, {"N", Count(ratio.n)}, {"lo", lo}, {"hi", hi}});
}

}  // namespace

std::string verdict(const Answer& answer) {
    return std::visit([](const auto& found) { return sentence(found); }, answer.found);
}

std::string to_text(const Answer& answer) {
    return verdict(answer) + std::visit([](const auto& found) { return precision(found); }, answer.found) +
           fmt::format(
               "\nThis rests on the law for every mass ratio (proofs/law.md) with its certificate\n"
               "{} (sha256 {}); dumbbell law checks it.\n",
               one_line(answer.file), certificate_sha256);
}

Json to_json(const Answer& answer) {
    Json json = std::visit([](const auto& found) { return fields(found); }, answer.found);
    json.add("file", answer.file);
    json.add("sha256", std::string(certificate_sha256));
    return json;
}

}  // namespace dumbbell::law
