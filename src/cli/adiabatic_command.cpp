#include "cli/adiabatic_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "arith/error.hpp"
#include "certificate/adiabatic_writer.hpp"
#include "certificate/atomic_file.hpp"
#include "cli/exit_code.hpp"
#include "cli/initial_argument.hpp"
#include "cli/messages.hpp"
#include "cli/progress.hpp"
#include "cli/ratio_argument.hpp"
#include "cli/stop_signals.hpp"
#include "prove/adiabatic.hpp"
#include "prove/adiabatic_branch.hpp"
#include "prove/deadline.hpp"
#include "report/adiabatic_report.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Prove the constants of the adiabatic invariant I = |phidot| (pi - arccos y) for a light mass beta1 = epsilon = delta^2
that spins fast: |phidot| = 1 and -delta <= ydot <= 0 before the first collision that counts.

  lemma3.1  one bounce and the next, at distance m delta^k from the vertical, k = 1/2: the errors of |phidot_+| and y_+
  cor3.2    the same with other exponents: --k
  thm3.3    |I_n - I_0| <= C delta while only the light mass bounces, at distance u_* from the vertical or more
  thm3.5    |I_N - I_0| <= C sqrt(delta) for a whole scattering whose first and last collision are at distance
            c sqrt(delta) or more; and an orbit that shows why the last one must be restricted too
  printed   that orbit alone: |I_N - I_0| > 3 under the hypotheses as they are printed

C is proved for all initial conditions, by a cover of theirs; it is compared with what one enclosed orbit attains. For
thm3.3 C holds for any number of bounces; --bounces limits the attained orbit only.

Examples:
  dumbbell adiabatic --delta 0.01                               Theorem 3.3 with its constant
  dumbbell adiabatic --delta 0:0.01                             for all delta up to 0.01
  dumbbell adiabatic --delta 0.01 --phi-margin 0.2,0.3,0.5      a table over the distance from the vertical
  dumbbell adiabatic --delta 0.01 --theorem cor3.2 --k 1/4
  dumbbell adiabatic --delta 0.01 --theorem thm3.5 --out scattering.dbc)";

constexpr const char* footer =
    R"(The fields of --json: proofs/json.md.

Exit codes: 0 certified; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; 130 or 143
stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

struct Options {
    std::string delta;
    std::string theorem = "thm3.3";
    std::optional<std::string> y, margins, exponents, bounces, budget;
    std::string accuracy = "0.1", out;
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    bool json = false;
    bool quiet = false;
};

/// Throws the same error with the option's name before it.
template <class Parse>
auto parse(const char* option, const std::string& text, const Parse& how) {
    try {
        return how(text);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

Rational parse_number(const char* option, const std::string& text) {
    return parse(option, text, [](const std::string& number) { return parse_rational(number); });
}

std::vector<Rational> parse_list(const char* option, const std::string& text) {
    std::vector<Rational> numbers;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        numbers.push_back(parse_number(option, text.substr(from, comma - from)));
        from = comma + 1;
    }
    return numbers;
}

int parse_exponent(const Rational& k) {
    const Rational sixteenths = k * 16;
    if (k < 0 || k > 1 || denominator(sixteenths) != 1) {
        throw InputError("--k must be a multiple of 1/16 from 0 to 1, for example 1/2 or 0.25");
    }
    return sixteenths.convert_to<int>();
}

AdiabaticClaim claim_of(const std::string& theorem) {
    return theorem == "thm3.3"    ? AdiabaticClaim::run
           : theorem == "thm3.5"  ? AdiabaticClaim::scattering
           : theorem == "printed" ? AdiabaticClaim::printed
                                  : AdiabaticClaim::bounce;
}

std::string default_margin(AdiabaticClaim claim) {
    return claim == AdiabaticClaim::bounce ? "1" : claim == AdiabaticClaim::run ? "3/10" : "1/2";
}

void require_applicable(const Options& options, AdiabaticClaim claim) {
    const auto refuse = [&](const char* option, const char* where) {
        throw InputError(fmt::format("{} is for {} only", option, where));
    };
    if (options.exponents && options.theorem != "cor3.2") {
        refuse("--k", "--theorem cor3.2");
    }
    if (options.bounces && claim != AdiabaticClaim::run) {
        refuse("--bounces", "--theorem thm3.3");
    }
    if (options.y && (claim == AdiabaticClaim::scattering || claim == AdiabaticClaim::printed)) {
        refuse("--y", "lemma3.1, cor3.2 and thm3.3");
    }
}

/// All hypotheses asked for: one for each distance and exponent.
std::vector<AdiabaticHypotheses> hypotheses(const Options& options) {
    AdiabaticHypotheses of;
    of.claim = claim_of(options.theorem);
    require_applicable(options, of.claim);
    of.delta = parse_quantity("--delta", options.delta);
    const char* heights = of.claim == AdiabaticClaim::run ? "0:0.9" : "0:1";
    of.heights = parse_quantity("--y", options.y.value_or(heights));
    std::vector<AdiabaticHypotheses> result;
    for (const Rational& k : parse_list("--k", options.exponents.value_or("1/2"))) {
        of.exponent = parse_exponent(k);
        for (const Rational& margin :
             parse_list("--phi-margin", options.margins.value_or(default_margin(of.claim)))) {
            of.margin = margin;
            require_sensible(of);
            result.push_back(of);
        }
    }
    return result;
}

/// K/delta, of the attained orbit of a run.
long most_collisions(const Options& options, const AdiabaticHypotheses& of) {
    constexpr long most = 1'000'000;
    const Rational factor = parse_number("--bounces", options.bounces.value_or("1"));
    if (factor <= 0) {
        throw InputError("--bounces must be greater than 0: orbits of n <= K/delta bounces are looked at");
    }
    if (!options.bounces || of.delta.first == 0) {
        return most;
    }
    const Rational number = factor / of.delta.first;
    return number >= most ? most : static_cast<long>(number.convert_to<double>());
}

void write_certificate(AdiabaticReport& report, const std::string& path, const AtomicFile& file) {
    CertificateText text = render(certificate_of(report.results.front().proof));
    file.commit(text.text);
    report.out = path;
    report.sha256 = std::move(text.sha256);
}

AdiabaticResult proved(const AdiabaticRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    AdiabaticResult result;
    result.proof = prove_adiabatic(request);
    if (request.of.claim == AdiabaticClaim::scattering) {
        AdiabaticRequest printed = request;
        printed.of.claim = AdiabaticClaim::printed;
        result.as_printed = prove_adiabatic(printed);
    }
    if (request.of.claim == AdiabaticClaim::bounce) {
        for (const AdiabaticState& state : result.proof.attained) {
            result.wrong_branch = std::max(result.wrong_branch.value_or(0), printed_branch_error(state));
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

int run(const Options& options) {
    const auto wanted = hypotheses(options);
    AdiabaticReport report{options.theorem, parse_number("--accuracy", options.accuracy), {}, {}, {}};
    if (report.accuracy <= 0 || report.accuracy > 1) {
        throw InputError("--accuracy must be greater than 0 and at most 1, for example 0.1 for 10 %");
    }
    if (!options.out.empty() && wanted.size() > 1) {
        throw InputError(
            "--out takes one statement: give one distance (--phi-margin) and one exponent (--k)");
    }
    std::optional<AtomicFile> file;
    if (!options.out.empty()) {
        file.emplace(options.out);
    }
    const Interrupted interrupted =
        deadline(options.budget ? std::optional(parse_duration(*options.budget)) : std::nullopt);
    bool complete = true;
    {
        Progress progress("boxes", options.quiet ? Loudness::quiet : Loudness::normal);
        for (const AdiabaticHypotheses& of : wanted) {
            AdiabaticRequest request;
            request.of = of;
            request.accuracy = report.accuracy;
            request.most_collisions = most_collisions(options, of);
            request.jobs = options.jobs;
            request.interrupted = interrupted;
            request.judged = [&](std::size_t more) { progress.advance(more); };
            report.results.push_back(proved(request));
            complete = complete && report.results.back().proof.complete();
        }
    }
    if (file && complete) {
        write_certificate(report, options.out, *file);
    }
    fmt::print("{}", options.json    ? to_json(report).dump(2) + "\n"
                     : options.quiet ? verdict(report)
                                     : to_text(report));
    if (complete) {
        return exit_done;
    }
    const bool stopped = stop_signal != 0;
    complain(fmt::format("{}{}",
                         stopped ? stopped_by() + ": not certified"
                         : interrupted()
                             ? "not certified: the budget is used up"
                             : "not certified: take a smaller delta (or range of them), a greater "
                               "--phi-margin or a higher --y",
                         options.out.empty() ? "" : "; no certificate is written"));
    return stopped ? exit_stopped : exit_not_certified;
}

}  // namespace

void add_adiabatic_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("adiabatic", description);
    command->footer(footer);
    command->add_option("--delta", options->delta, "square root of the light mass, or closed range D1:D2")
        ->required()
        ->type_name("D|D1:D2");
    command->add_option("--theorem", options->theorem, "the statement")
        ->check(CLI::IsMember({"lemma3.1", "cor3.2", "thm3.3", "thm3.5", "printed"}))
        ->capture_default_str();
    command
        ->add_option("--y", options->y,
                     "heights of the centre of mass before the first collision; default 0:1, thm3.3: 0:0.9")
        ->type_name("Y1:Y2");
    command
        ->add_option(
            "--phi-margin", options->margins,
            "distance from the vertical: m of m delta^k (default 1), u_* (thm3.3: 0.3) or c of c sqrt(delta) "
            "(thm3.5, printed: 1/2); or a list of them")
        ->type_name("M[,M...]");
    command
        ->add_option("--bounces", options->bounces,
                     "thm3.3: look for the attained orbit with at most K/delta bounces (the bound holds for "
                     "any number)")
        ->type_name("K");
    command
        ->add_option("--k", options->exponents,
                     "cor3.2: the exponent, a multiple of 1/16 from 0 to 1; or a list")
        ->type_name("K[,K...]");
    command->add_option("--accuracy", options->accuracy, "of the bound over what is attained, relative")
        ->type_name("A")
        ->capture_default_str();
    command->add_option("--budget", options->budget, "stop after this time: 30s, 10m, 2h")->type_name("TIME");
    command->add_option("--jobs", options->jobs, "threads; the result does not depend on it")
        ->check(CLI::Range(1, 1024))
        ->default_str("all cores");
    command->add_option("--out", options->out, "write the certificate to FILE (FILE.gz: compressed)")
        ->check([](const std::string& file) { return file.empty() ? "the file name is empty" : ""; })
        ->type_name("FILE");
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "the constants alone, a line each, and no progress");
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return run(*options); }); });
}

}  // namespace dumbbell
