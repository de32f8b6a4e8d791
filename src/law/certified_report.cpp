#include "law/certified_report.hpp"

#include <fmt/core.h>

#include "base/printable.hpp"

namespace dumbbell::law {

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

}  // namespace dumbbell::law
