#include <fmt/core.h>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/commands/verify.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/standard_input.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "flight/paper_bound.hpp"
#include "staircase/law_report.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* description =
    R"(Prove what a staircase says as a whole: never decreasing, below the paper's bound.

That is: the maximum never decreases with the mass ratio, the paper's bound is never attained, and how far N(q) is from
C sqrt q. The independent verifier checks the certificate first; what follows rests on its pieces alone. C, the limit of
N(q) / sqrt q (theorem 4 of proofs/theorem.md), is enclosed by verified quadrature.

Examples:
  dumbbell certify 1:10000 --gap 1e-12 --out stairs.dbc
  dumbbell law stairs.dbc)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 proved; 1 internal error; 2 wrong usage, or a file that is not verified; 3 not proved by this file.)";

constexpr std::array options{
    argument("FILE", "certificate over a range of mass ratios, scene dumbbell (-: the standard input)")
        .required(),
    Option{"--digits", "N", "digits of C, all of them proved", "50"}.from(1, 1000), json_option,
    flag("--quiet", "what is proved, without the constant")};

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
            fmt::format("'{}' is no staircase: the law needs a range of mass ratios (dumbbell "
                        "certify LO:HI --out FILE)",
                        file));
    }
    if (certificate.q_hi() > flight::paper_bound_limit()) {
        throw InputError(fmt::format("'{}' reaches beyond the mass ratio 3e31: no law of that", file));
    }
    return certificate;
}

int run(const Given& given) {
    const std::string name_given = given.text("FILE"), file = input_file(name_given);
    const collisions::Certificate certificate = read_staircase(file);
    staircase::LawReport report{.file = name_given,
                                .verdict = verified(file, name(certificate.scene), verbosity_of(given)),
                                .digits = static_cast<int>(given.number("--digits")),
                                .law = {}};
    const PrecisionScope scope(static_cast<int>(report.digits * 3.33) + 64);
    report.law = staircase::law_of(certificate);
    fmt::print("{}", shown(report, given));
    return all_proved(report.law) ? exit_done : exit_not_certified;
}

}  // namespace

constinit const Command law_command{"law", "Check", description, footer, options, run};

}  // namespace dumbbell::cli
