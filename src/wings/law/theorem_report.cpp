#include "law/theorem_report.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "law/certificate.hpp"
#include "law/constants.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"

namespace dumbbell::law {
namespace {

/// The first digits of a constant that are certain, as many as asked for.
std::string digits_of(const BigInterval& x, int digits) {
    const auto shared = shared_digits(exact_lo(x), exact_hi(x), digits);
    require(shared.has_value(), "a constant was not enclosed to the digits asked for");
    return dumbbell::to_text(*shared);
}

/// C and c0.
std::pair<std::string, std::string> constants_of(const TheoremReport& report) {
    const PrecisionScope scope(static_cast<int>(report.digits * 3.33) + 64);
    const Constants constants;
    return {digits_of(constants.C, report.digits), digits_of(constants.c0, report.digits)};
}

/// What rests on a computation, and where its proof is.
std::string source(const TheoremReport& report) {
    if (report.verdict) {
        return fmt::format("Its proof is proofs/law.md; the computed part of it is verified:\n{}\n  {}\n",
                           one_line(*report.out), one_line(*report.verdict));
    }
    std::string text = fmt::format(
        "Its proof is proofs/law.md; the computed part of it was proved in {}: the steps to N = {} "
        "to {} by\ncovers and witnesses, and all beyond them by a cover of {} boxes and two of equal "
        "parts.\n",
        time_text(report.seconds), first_step, last_step, report.leaves);
    if (report.out) {
        text += fmt::format("Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {}\n",
                            one_line(*report.out), *report.sha256, shell_file(*report.out));
    }
    return text;
}

}  // namespace

std::string verdict(const TheoremReport& /*report*/) {
    return "For every mass ratio q >= q_c(9) = 62.7137...:\n"
           "    2 + floor(C sqrt q - c0 q^(-1/4)) <= N(q) <= 2 + floor(C sqrt q),\n"
           "and 0.980 <= N(q) - C sqrt q <= 2.115 for every q >= 1.\n";
}

std::string to_text(const TheoremReport& report) {
    const auto [C, c0] = constants_of(report);
    return fmt::format(
        "{}\nC  = integral of sin((pi/2) / cos theta), theta from 0 to pi/3\n   = {}...\n"
        "c0 = 4 |zeta(-1/2)| / (3^(3/4) sqrt pi)\n   = {}...\n\n{}",
        verdict(report), C, c0, source(report));
}

Json to_json(const TheoremReport& report) {
    const auto [C, c0] = constants_of(report);
    return Json::object({{"schema", "dumbbell-law-theorem-1"},
                         {"C", C},
                         {"c0", c0},
                         {"verdict", report.verdict},
                         {"file", report.out},
                         {"sha256", report.sha256}});
}

}  // namespace dumbbell::law
