#include "cli/commands/certify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/commands/open_pieces.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "collisions/certify.hpp"
#include "collisions/proof_report.hpp"
#include "collisions/witness_orbit.hpp"
#include "collisions/writer.hpp"
#include "number/ratio_argument.hpp"
#include "starts/witness_start.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

struct Options {
    CertifyClaim claim;
    std::string budget;
    std::string out;
    int jobs = all_cores();
    bool witness = false;
    bool json = false;
    bool quiet = false;
};

constexpr const char* description =
    R"(Prove the greatest number of collisions for a mass ratio, or every ratio of a range.

RATIO is q = heavy mass / light mass: 10, 4.6, 1e6 or 9/2, exactly as written. LO:HI is a closed range. Below 1 the
masses are swapped.

Examples:
  dumbbell certify 10                          at most 4 collisions, and 4 occur
  dumbbell certify 10 --witness                ... and print an orbit that has them
  dumbbell certify 1:100 --out stairs.dbc      every mass ratio from 1 to 100, with a certificate
  dumbbell certify 4.6:4.61 --gap 1e-9 --json  a narrower gap around the critical ratio, for scripts

A range with --out FILE keeps its finished pieces in FILE.partial/ until all are: stopped (Ctrl-C), killed or out of
time, the same command goes on with them and ends with the same file.)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 proved; 1 internal error; 2 wrong usage or input; 3 not decided (within the budget); 130 or 143 stopped by
SIGINT (Ctrl-C) or SIGTERM: what is kept is said, and FILE not written.)";

/// Throws InputError if the options contradict one another.
void check_combination(const Options& options) {
    if (options.witness && options.claim.scene != "dumbbell") {
        throw InputError("--witness prints orbits of the dumbbell: leave it out with --scene " +
                         options.claim.scene);
    }
}

CertifyRequest request_of(const Options& options, const RatioArgument& ratio) {
    CertifyRequest request = request_of(options.claim, ratio);
    request.jobs = options.jobs;
    if (!options.budget.empty()) {
        request.budget = parse_duration(options.budget);
    }
    return request;
}

std::vector<ProvedPiece> prove(CertifyRequest request, Loudness loudness) {
    const bool single = request.q_lo == request.q_hi;
    Progress progress(single ? "boxes" : "steps", loudness, single ? "proving" : "looking for steps");
    request.placed = [&](std::size_t done, std::size_t all) { progress.update(done, all); };
    request.judged = [&](std::size_t boxes) { progress.advance(boxes); };
    request.progress = [&](std::size_t done, std::size_t total, long n) {
        progress.enter("proving", "pieces");
        progress.update(done, total, n);
    };
    request.damaged = [&](const std::string& file) {
        progress.note(fmt::format("'{}' is damaged: its piece is proved again", file));
    };
    return certify(request);
}

ProofReport describe(const CertifyRequest& request, const std::vector<ProvedPiece>& pieces, double seconds,
                     bool witness, Loudness loudness) {
    const Progress progress("", loudness, "enclosing the orbits of witnesses");
    const Interrupted interrupted = deadline(std::nullopt);
    ProofReport report{.scene = request.scene,
                       .section = request.section,
                       .q_lo = request.q_lo,
                       .q_hi = request.q_hi,
                       .gap = request.gap,
                       .jobs = request.jobs,
                       .seconds = seconds,
                       .undecided = undecided_share(pieces),
                       .rows = {},
                       .out = {},
                       .sha256 = {}};
    for (const ProvedPiece& p : pieces) {
        ReportRow row{&p.piece, p.margin, p.width, p.seconds, {}, {}};
        if (witness && p.piece.witness) {
            row.orbit = witness_orbit(*p.piece.witness, p.piece.q_lo, p.piece.bits);
            row.start =
                row.orbit.empty() ? std::nullopt : witness_start(*p.piece.witness, p.piece.q_lo, interrupted);
        }
        report.rows.push_back(std::move(row));
    }
    return report;
}

void write_certificate(const std::vector<ProvedPiece>& pieces, const Output& output, ProofReport& report) {
    Certificate certificate{.program = "dumbbell",
                            .version = DUMBBELL_VERSION,
                            .pieces = {},
                            .scene = report.scene,
                            .section = report.section};
    for (const ProvedPiece& p : pieces) {
        certificate.pieces.push_back(p.piece);
    }
    SealedText text = render(certificate);
    output.commit(text.text);
    report.out = output.file();
    report.sha256 = std::move(text.sha256);
}

int run(const Options& options) {
    const RatioArgument ratio = parse_ratio_argument(options.claim.ratio);
    check_combination(options);
    CertifyRequest request = request_of(options, ratio);  // before the output file is touched
    const Output output(options.out, {}, options.json ? "--json" : nullptr);
    std::optional<PieceStore> store;
    const std::string partial = options.out + ".partial";
    if (output.file()) {
        if (ratio.lo < ratio.hi) {  // it may take long: its finished pieces are kept
            request.store = &store.emplace(
                partial, StoredClaim{request.scene, request.section, ratio.lo, ratio.hi, request.gap});
        } else {
            PieceStore::require_none(partial);
        }
    }
    const auto start = std::chrono::steady_clock::now();
    const Loudness loudness = options.quiet ? Loudness::quiet : Loudness::normal;
    const auto pieces = prove(request, loudness);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const bool open = std::any_of(pieces.begin(), pieces.end(),
                                  [](const ProvedPiece& p) { return p.piece.status() == Status::open; });
    const std::string kept_in = store ? partial : "";
    if (open && stop_signal != 0) {
        complain(fmt::format("{}: {}", stopped_by(), kept_when_stopped(request, pieces, kept_in)));
        return exit_stopped;
    }

    ProofReport report = describe(request, pieces, seconds, options.witness, loudness);
    if (output.is_wanted()) {
        write_certificate(pieces, output, report);
    }
    if (store && !open) {
        store->remove();
    }
    if (options.json) {
        fmt::print("{}", json_text(to_json(report)));
    } else if (options.quiet) {
        fmt::print(output.report(), "{}", verdict(report));
    } else {
        if (ratio.swapped) {
            fmt::print(output.report(), "Ratios below 1: the masses are swapped, q -> 1/q.\n");
        }
        fmt::print(output.report(), "{}{}{}", orbits_to_text(report), options.witness ? "\n" : "",
                   to_text(report));
    }
    if (open) {
        complain(advice(request, pieces, kept_in));
    }
    return open ? exit_not_certified : exit_done;
}

}  // namespace

void add_certify_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("certify", description);
    command->footer(footer);
    add_claim_options(*command, options->claim)->required();
    add_out_option(*command, options->out, {Content::certificate});
    add_jobs_option(*command, options->jobs);
    command->add_option("--budget", options->budget, "give up after this time: 30s, 10m, 2h")
        ->type_name("TIME");
    CLI::Option* witness = command->add_flag("--witness", options->witness,
                                             "print an orbit that attains the maximum, every collision "
                                             "enclosed, and a start in the air for trace");
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "no table and no progress: what is proved, in a sentence")
        ->excludes(witness);
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return run(*options); }); });
}

}  // namespace dumbbell
