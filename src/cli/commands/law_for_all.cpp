#include <fmt/core.h>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "certificates/any_reader.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/commands/law_modes.hpp"
#include "cli/commands/verify.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/standard_input.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/lines.hpp"
#include "file/shipped.hpp"
#include "file/verifier_program.hpp"
#include "law/answer_reports.hpp"
#include "law/prove.hpp"
#include "law/theorem_report.hpp"
#include "law/writer.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

std::optional<law::LawCertificate> prove_anew(const Given& given) {
    Progress progress("boxes", verbosity_of(given), "covering the layer");
    law::LawRequest request;
    request.jobs = jobs_of(given);
    request.interrupted = deadline(std::nullopt);
    request.observer = &progress;
    return prove_law(request);
}

/// The certificate of the law that was named, or the shipped one; `another` is how to name one. Throws
/// InputError for any other file.
std::string law_certificate(const std::string& name, std::string_view another) {
    std::string file = name.empty() ? shipped_certificate(law::certificate_name, another) : input_file(name);
    require_readable(file);
    if (!law::is_law_certificate(file)) {
        throw InputError(
            fmt::format("'{}' is not a certificate of the law for every mass ratio "
                        "(dumbbell law --prove --out FILE)",
                        name));
    }
    return file;
}

law::AtRatioReport answer_at(const Rational& q, const std::string& file, Verbosity verbosity) {
    const Progress progress("", verbosity, "reading");
    std::string sha256 = certificates::sealed_digest(file);
    return {law::law_at(q, law::read_steps(file)), file, std::move(sha256)};
}

/// The law needs no search: what is about one is refused.
void refuse_with_law(const Given& given, std::initializer_list<const char*> options) {
    for (const char* option : options) {
        if (given.has(option)) {
            throw InputError(fmt::format("{} means nothing with --by law: leave it out", option));
        }
    }
}

/// N of `critical --by law`, also as 1e50. Throws InputError.
Integer parse_law_count(const std::string& text) {
    if (text.find(':') != std::string::npos) {
        throw InputError(
            fmt::format("--by law takes one N, no range: '{}' (a range: dumbbell critical N1:N2 without it)",
                        shortened(text)));
    }
    const Rational n = parse_number("N", text);
    if (denominator(n) != 1 || n <= law::last_step || n > parse_rational("1e100")) {
        throw InputError(fmt::format(
            "--by law encloses q_c(N) for one whole N from {} to 10^100, not for '{}'{}", law::last_step + 1,
            shortened(text), n <= law::last_step ? ": for less, dumbbell critical N" : ""));
    }
    return numerator(n);
}

}  // namespace

int law_for_all(const Given& given, const std::string& file) {
    law::TheoremReport report{.digits = static_cast<int>(given.number("--digits")),
                              .out = given.has("FILE") ? given.text("FILE") : file};
    {
        Progress progress("", verbosity_of(given), "verifying");
        report.verdict = verified_law(file, progress);
        report.sha256 = digest_in(*report.verdict);
    }
    fmt::print("{}", shown(report, given));
    return exit_done;
}

int prove_law_for_all(const Given& given) {
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    const Stopwatch watch;
    const auto certificate = prove_anew(given);
    if (!certificate) {
        const std::string nothing = output.is_wanted() ? "; no certificate is written" : "";
        if (stop_signal != 0) {
            return stopped("not proved" + nothing);
        }
        complain("the law was not proved, which is a fault of this program: please report it" + nothing);
        return exit_not_certified;
    }
    law::TheoremReport report{.digits = static_cast<int>(given.number("--digits")),
                              .leaves = leaves_of(certificate->layer),
                              .seconds = watch.seconds()};
    if (output.is_wanted()) {
        write(render(*certificate), output, report);
    }
    fmt::print(output.report(), "{}", shown(report, given));
    return exit_done;
}

int law_at_one_ratio(const Given& given) {
    const RatioArgument ratio = parse_ratio_argument(given.text("--ratio"));
    if (ratio.lo != ratio.hi) {
        throw InputError("--ratio takes one mass ratio, for example 1e100 or 7/3");
    }
    const law::AtRatioReport report =
        answer_at(ratio.lo, law_certificate(given.text("FILE"), "law FILE --ratio Q"), verbosity_of(given));
    fmt::print("{}", shown(report, given));
    return report.at.lower == report.at.upper ? exit_done : exit_not_certified;
}

int certify_by_law(const Given& given) {
    refuse_with_law(given, {"--scene", "--section", "--gap", "--jobs", "--budget", "--witness"});
    const RatioArgument ratio = parse_ratio_argument(given.text("RATIO"));
    if (ratio.lo != ratio.hi) {
        throw InputError(
            "--by law takes one mass ratio, for example 1e100 or 7/3: a range is proved without it");
    }
    const std::string file = law_certificate(given.text("--law"), "certify Q --by law --law FILE");
    const Output output(given.text("--out"), {file}, given.has("--json") ? "--json" : nullptr);
    law::CertifiedReport report{.answer = answer_at(ratio.lo, file, verbosity_of(given))};
    if (given.has("--law")) {
        report.law = given.text("--law");
    }
    const law::AtRatio& at = report.answer.at;
    if (output.is_wanted()) {
        write(render(at, report.answer.sha256), output, report);
    }
    const bool is_text = !given.has("--json") && !given.has("--quiet");
    fmt::print(output.report(), "{}{}", ratio.swapped && is_text ? masses_are_swapped : "",
               shown(report, given));
    if (at.lower == at.upper) {
        return exit_done;
    }
    complain("not decided: the law leaves two values at this ratio; without --by law a cover may decide");
    return exit_not_certified;
}

int critical_by_law(const Given& given) {
    refuse_with_law(given, {"--digits", "--confirm", "--out", "--budget", "--jobs"});
    const Integer n = parse_law_count(given.text("N"));
    const std::string file = shipped_certificate(law::certificate_name);
    const law::CriticalByLaw report{n, law::critical_ratio(n), file, certificates::sealed_digest(file)};
    fmt::print("{}", shown(report, given));
    return exit_done;
}

}  // namespace dumbbell::cli
