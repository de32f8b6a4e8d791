#include "cli/commands/law.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "base/error.hpp"
#include "cli/commands/verify.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/standard_input.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "flight/paper_bound.hpp"
#include "staircase/law_report.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
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

struct Options {
    std::string file;
    int digits = 50;
    bool json = false;
    bool quiet = false;
};

/// The staircase that the law is about, as far as the file can be read. Throws InputError for anything else.
Certificate read_staircase(const std::string& file) {
    Certificate certificate = read_certificate(file);
    if (certificate.scene != Scene::dumbbell) {
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
    if (certificate.q_hi() > paper_bound_limit()) {
        throw InputError(fmt::format("'{}' reaches beyond the mass ratio 3e31: no law of that", file));
    }
    return certificate;
}

int run(const Options& options) {
    const std::string file = input_file(options.file);
    const Certificate certificate = read_staircase(file);
    LawReport report{.file = options.file,
                     .verdict = verified(file, name(certificate.scene),
                                         options.quiet ? Loudness::quiet : Loudness::normal),
                     .digits = options.digits,
                     .law = {}};
    const PrecisionScope scope(static_cast<int>(options.digits * 3.33) + 64);
    report.law = law_of(certificate);
    if (options.json) {
        fmt::print("{}", json_text(to_json(report)));
    } else if (options.quiet) {
        fmt::print("{}", verdict(report));
    } else {
        fmt::print("{}", to_text(report));
    }
    return all_proved(report.law) ? exit_done : exit_not_certified;
}

}  // namespace

void add_law_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("law", description);
    command->footer(footer);
    command
        ->add_option("FILE", options->file,
                     "certificate over a range of mass ratios, scene dumbbell (-: the standard input)")
        ->required();
    command->add_option("--digits", options->digits, "digits of C, all of them proved")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "what is proved, without the constant");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace dumbbell
