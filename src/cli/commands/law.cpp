#include <fmt/core.h>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/commands/law_modes.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/standard_input.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/shipped.hpp"
#include "law/certificate.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* law_description =
    R"(State the law of N(q) for every mass ratio, or what one staircase says as a whole.

Without a FILE: for every q >= 62.72, 2 + floor(C sqrt q - c0 q^(-1/4)) <= N(q) <= 2 + floor(C sqrt q), with its two
constants (proofs/law.md). What of it rests on a computation is a certificate that comes with the program; the
independent verifier checks it first. --prove makes that certificate. --ratio says what the law says of one mass
ratio up to 10^1000: N(q), or the two values that remain where q is too near a step; it is not verified again then.

With a staircase, a FILE by dumbbell certify LO:HI: the maximum never decreases with the mass ratio, the paper's bound
is never attained, and how far N(q) is from C sqrt q. The verifier checks the certificate first; what follows rests on
its pieces alone. C, the limit of N(q) / sqrt q (theorem 4 of proofs/theorem.md), is enclosed by verified quadrature.

Examples:
  dumbbell law                                the law for every mass ratio, verified
  dumbbell law --ratio 1e100                  N at q = 10^100
  dumbbell law --prove --out law.dbc          its certificate, anew
  dumbbell certify 1:10000 --gap 1e-12 --out stairs.dbc
  dumbbell law stairs.dbc                     what this staircase says)";

constexpr const char* law_footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 proved; 1 internal error; 2 wrong usage, or a file that is not verified; 3 not proved by this file, or two
values remain (--ratio); 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array law_options{
    argument("FILE",
             "certificate of a staircase, scene dumbbell, or of the law (-: the standard input); none: "
             "that of the law, which comes with the program"),
    flag("--prove", "prove the law's computed part anew").excludes("--ratio"),
    certificate_option.needs("--prove"),
    jobs_option.needs("--prove"),
    Option{"--ratio", "RATIO", "what the law says of this mass ratio: 1e100, 7/3"}.excludes("--prove"),
    Option{"--digits", "N", "digits of C and c0, all of them proved", "50"}.from(1, 1000),
    json_option,
    flag("--quiet", "what is proved, without the constants, and no progress")};

/// The one that is named, or that comes with the program.
std::string file_of(const Given& given) {
    if (!given.has("FILE")) {
        return shipped_certificate(law::certificate_name, "law FILE");
    }
    const Progress progress("", verbosity_of(given), "reading");
    return input_file(given.text("FILE"));
}

int run_law(const Given& given) {
    if (given.has("--prove") && given.has("FILE")) {
        throw InputError(
            "--prove makes the certificate of the law: name where to write it by --out, and no FILE");
    }
    if (given.has("--prove")) {
        return stoppable([&] { return prove_law_for_all(given); });
    }
    if (given.has("--ratio")) {
        return law_at_one_ratio(given);
    }
    const std::string file = file_of(given);
    return law::is_law_certificate(file) ? law_for_all(given, file) : law_of_staircase(given, file);
}

}  // namespace

constinit const Command law_command{"law", "Check", law_description, law_footer, law_options, run_law};

}  // namespace dumbbell::cli
