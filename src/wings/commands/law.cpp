#include <fmt/core.h>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/commands/verify.hpp"
#include "cli/list/list.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/sealed_lines.hpp"
#include "file/shipped.hpp"
#include "file/verifier_program.hpp"
#include "law/answer_report.hpp"
#include "law/prove.hpp"
#include "law/theorem_report.hpp"
#include "law/writer.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* law_description =
    R"(State the law: a formula with two close bounds, for every mass ratio.

For every q >= 62.72, 2 + floor(C sqrt q - c0 q^(-1/4)) <= N(q) <= 2 + floor(C sqrt q), with its two constants
(proofs/law.md). Its computed part is a certificate that comes with the program. The independent verifier checks it
first. --prove makes it.

--ratio says what the law says of one mass ratio up to 10^1000: N(q), or the two values that remain where q is too near
a step. --count encloses one critical ratio q_c(N), at which the maximum steps from N - 1 to N. Both rest on that
certificate, and name its SHA-256; they do not verify it again. --ratio, --count, --list and --prove exclude each other.

Examples:
  dumbbell law                                the law for every mass ratio, verified
  dumbbell law --ratio 1e100                  N at q = 10^100
  dumbbell law --count 1e50                   the ratio at which the maximum steps to 10^50
  dumbbell law --prove --out law.dbc          make its certificate again)";

constexpr const char* law_footer =
    R"(Exit codes: 0 proved; 1 internal error; 2 wrong usage, also of one line of a list, or a certificate that is not
verified; 3 two values remain (--ratio, --list); 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array law_topics{Topic{"lists", lists_text,
                                      R"(--list does not go with --digits or --quiet.

Example:
  dumbbell law --list ratios.txt              N at each ratio of a file)"}};

constexpr std::array law_options{
    Option{"--ratio", "RATIO", "what the law says of this mass ratio: 1e100, 7/3"}.excludes(
        "--count,--prove"),
    list_option.excludes("--ratio,--count,--prove,--digits,--quiet"),
    strict_option,
    Option{"--count", "N", "enclose the critical ratio q_c(N), N from 903 to 10^100"}.excludes("--prove"),
    flag("--prove", "prove the law's computed part anew"),
    certificate_option.needs("--prove"),
    jobs_option.needs("--prove,--list"),
    Option{"--digits", "N", "digits of C and c0, all of them proved", "50"}.from(1, 1000).excludes(
        "--ratio,--count"),
    json_option,
    flag("--quiet", "what is proved, without the constants, and no progress")};

int state_law(const Given& given) {
    const std::string file = shipped_certificate(law::certificate_name);
    law::TheoremReport report{.digits = static_cast<int>(given.number("--digits")), .out = file};
    {
        Progress progress("", verbosity_of(given), "verifying");
        report.verdict = verified_law(file, progress);
        report.sha256 = digest_in(*report.verdict);
    }
    fmt::print("{}", shown(report, given));
    return exit_done;
}

std::optional<law::LawCertificate> prove_anew(const Given& given) {
    Progress progress("boxes", verbosity_of(given), "covering the layer");
    law::LawRequest request;
    request.jobs = jobs_of(given);
    request.interrupted = deadline(std::nullopt);
    request.observer = &progress;
    return prove_law(request);
}

int make_certificate(const Given& given) {
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
                              .leaves = certificate->layer.size() / 2 + 1,  // one more than splits
                              .seconds = watch.seconds()};
    if (output.is_wanted()) {
        write(render(*certificate), output, report);
    }
    fmt::print(output.report(), "{}", shown(report, given));
    return exit_done;
}

/// The certificate on which answers rest. It was verified with this program, so that another one, true or
/// not, is refused: throws InputError.
std::string certificate_of_answers() {
    std::string file = shipped_certificate(law::certificate_name);
    if (sealed_digest(file) != law::certificate_sha256) {
        throw InputError(
            fmt::format("'{}' is not the certificate of the law that comes with this program, whose sha256 "
                        "is {}: install the program with its certificates",
                        file, law::certificate_sha256));
    }
    return file;
}

law::AtRatio law_at_one(const char* who, const RatioArgument& ratio,
                        const std::vector<law::StepEnds>& steps) {
    if (ratio.lo != ratio.hi) {
        throw InputError(fmt::format("{} takes one mass ratio, for example 1e100 or 7/3", who));
    }
    return law::law_at(ratio.lo, steps);
}

int answer_at_ratio(const Given& given) {
    const RatioArgument ratio = parse_ratio_argument(given.text("--ratio"));
    const std::string file = certificate_of_answers();
    const law::AtRatio at = law_at_one("--ratio", ratio, law::read_steps(file));
    fmt::print("{}", shown(law::Answer{at, file}, given));
    return at.lower == at.upper ? exit_done : exit_not_certified;
}

int answer_at_ratios(const Given& given) {
    const std::string file = certificate_of_answers();
    const auto steps = law::read_steps(file);
    return answer_list(given, [&](const std::string& ratio, const std::string& /*out*/) {
        const law::AtRatio at = law_at_one("the law", parse_ratio_argument(ratio), steps);
        return ListAnswer{.rows = {{at.q, at.q, Count(at.lower), Count(at.upper)}},
                          .is_decided = at.lower == at.upper,
                          .json = given.has("--json") ? to_json(law::Answer{at, file}) : Json()};
    });
}

/// N of --count, also as 1e50. Throws InputError.
Integer parse_law_count(const std::string& text) {
    const Rational n = parse_number("--count", text);
    if (denominator(n) != 1 || n <= law::last_step || n > parse_rational("1e100")) {
        throw InputError(fmt::format("--count takes one whole N from {} to 10^100, not '{}'{}",
                                     law::last_step + 1, shortened(text),
                                     n <= law::last_step ? ": for less, dumbbell critical N" : ""));
    }
    return numerator(n);
}

int answer_at_count(const Given& given) {
    const Integer n = parse_law_count(given.text("--count"));
    const std::string file = certificate_of_answers();
    fmt::print("{}", shown(law::Answer{law::CriticalRatio{n, law::critical_ratio(n)}, file}, given));
    return exit_done;
}

int run_law(const Given& given) {
    if (given.has("--prove")) {
        return stoppable([&] { return make_certificate(given); });
    }
    if (given.has("--list")) {
        return stoppable([&] { return answer_at_ratios(given); });
    }
    return given.has("--ratio")   ? answer_at_ratio(given)
           : given.has("--count") ? answer_at_count(given)
                                  : state_law(given);
}

}  // namespace

constinit const Command law_command{"law",   more_group, law_description, law_footer, law_options,
                                    run_law, {},         nullptr,         law_topics};

}  // namespace dumbbell::cli
