#include <fmt/core.h>

#include "base/error.hpp"
#include "cli/commands/law_modes.hpp"
#include "cli/commands/verify.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "flight/paper_bound.hpp"
#include "staircase/law_report.hpp"

namespace dumbbell::cli {
namespace {

/// The staircase that the law is about, as far as the file can be read. Throws InputError for anything else.
collisions::Certificate read_staircase(const std::string& file) {
    collisions::Certificate certificate = collisions::read_certificate(file);
    if (certificate.scene != collisions::Scene::dumbbell) {
        throw InputError(
            fmt::format("'{}' is a certificate of the scene {}: the law is one of the dumbbell "
                        "(dumbbell certify LO:HI --out FILE)",
                        file, name(certificate.scene)));
    }
    if (certificate.q_lo() == certificate.q_hi()) {
        throw InputError(
            fmt::format("'{}' is not a staircase: the law needs a range of mass ratios (dumbbell "
                        "certify LO:HI --out FILE)",
                        file));
    }
    if (certificate.q_hi() > flight::paper_bound_limit()) {
        throw InputError(fmt::format("'{}' reaches beyond the mass ratio 3e31: no law of that", file));
    }
    return certificate;
}

staircase::LawReport report_on(const Given& given, const std::string& file, int digits) {
    Progress progress("", verbosity_of(given), "reading");
    const collisions::Certificate certificate = read_staircase(file);
    std::string verdict = verified(file, certificate.sha256, name(certificate.scene), progress);
    progress.enter("finding the law", "");
    return {given.text("FILE"), std::move(verdict), digits, staircase::law_of(certificate)};
}

}  // namespace

int law_of_staircase(const Given& given, const std::string& file) {
    const auto digits = static_cast<int>(given.number("--digits"));
    const PrecisionScope scope(static_cast<int>(digits * 3.33) + 64);
    const staircase::LawReport report = report_on(given, file, digits);
    fmt::print("{}", shown(report, given));
    return all_proved(report.law) ? exit_done : exit_not_certified;
}

}  // namespace dumbbell::cli
