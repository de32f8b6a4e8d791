#include "collisions/certify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/claims/body.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/commands.hpp"
#include "cli/commands/open_pieces.hpp"
#include "cli/commands/rectangle.hpp"
#include "cli/commands/start_in_the_air.hpp"
#include "cli/list/list.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "collisions/claim.hpp"
#include "collisions/part.hpp"
#include "collisions/proof_report.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "collisions/witness_orbit.hpp"
#include "collisions/writer.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {

using collisions::CertifyRequest;
using collisions::ProvedPiece;

namespace {

constexpr const char* certify_description =
    R"(Prove the greatest number of collisions for a mass ratio, or every ratio of a range.

RATIO is q = heavy mass / light mass: 10, 4.6, 1e6 or 9/2, exactly as written. LO:HI is a closed range. Below 1 the
masses are swapped. The dumbbell moves in a vertical plane; in space there may be more collisions.

Examples:
  dumbbell certify 10                          at most 4 collisions, 4 occur, and a start that has them
  dumbbell certify 10 --witness                ... and print an orbit that has them
  dumbbell certify 1:100 --out stairs.dbc      every mass ratio from 1 to 100, with a certificate
  dumbbell certify 4.6:4.61 --gap 1e-9 --json  a narrower gap around the critical ratio, for scripts
  dumbbell certify 1:1e8 --gap 1e-9 --part 7/64 --out part-07.dbc    one of 64 parts, for dumbbell join

With --out FILE a range keeps its finished pieces in FILE.partial/. If it is stopped (Ctrl-C), killed or out of time,
the same command goes on from there, and ends with the same file.

No law is used. dumbbell law --ratio RATIO says what the law for every mass ratio says of one, up to 10^1000.)";

constexpr const char* certify_footer =
    R"(Exit codes: 0 proved; 1 internal error; 2 wrong usage or input, also of one line of a list; 3 not decided (within the
budget); 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: the pieces kept are reported, FILE is not written.)";

constexpr std::array certify_topics{
    Topic{
        "bodies", "Prove it of a rigid body that touches the floor with two points, or of a range of them.",
        R"(A body is RATIO with --rod-mass, or --coin, or --rho with --inertia. It moves in a vertical plane; in space nothing
bounds a coin. proofs/body.md says what bodies are.

Examples:
  dumbbell certify --coin                          a thin coin: at most 4 collisions, and 4 occur
  dumbbell certify 10 --rod-mass 1/100             the rod has a hundredth of the mass of its ends
  dumbbell certify --rho 1 --inertia 2:5 --out symmetric.dbc    symmetric ones, with the uniform rod and the coin
  dumbbell certify --rho 0.3:0.4 --inertia 10:18                a rectangle of bodies: all of them have 5
  dumbbell certify --rho 0.01:1 --inertia 1:100 --decided 0.99 --out plane.dbc    the plane, in cells)"},
    Topic{
        "lists", lists_text,
        R"(--out names a new folder, for the certificates. The same command goes on with the lines that have none yet; until all
have one, dumbbell-verify refuses the folder's claims.tsv. --list does not go with --part, --witness or --quiet. With
--rho the lines are Q of bodies, with --rod-mass mass ratios of their ends; the table has Q.

Examples:
  dumbbell certify --list ratios.txt --out answers     each ratio of a file, with a folder of certificates
  dumbbell certify --list inertias.txt --rho 1/2       each Q of a file)"}};

constexpr std::array certify_options = joined(
    std::array{ratio_option}, claim_options, body_options,
    std::array{
        Option{"--decided", "SHARE",
               "of --rho LO:HI with --inertia LO:HI: the number of each of so many of the bodies with Q "
               "rho > 1, by area in (log rho, log Q), from 0 to 1; not one number for all of them"}
            .needs("--rho")
            .of("bodies"),
        list_option.excludes("RATIO,--coin,--inertia,--decided,--part,--witness,--quiet"), strict_option,
        part_option, certificates_option, jobs_option,
        budget_option.saying("give up after this time: 30s, 10m, 2h"),
        flag("--witness",
             "print an orbit that attains the maximum, every collision enclosed; if it has up to 5000 "
             "collisions, also a start in the air for trace, where one is found")
            .excludes("--quiet"),
        json_option, flag("--quiet", "no table and no progress: what is proved, in a sentence")});

std::optional<collisions::RatioPart> part_of(const Given& given, const collisions::Claim& whole) {
    if (!given.has("--part")) {
        return std::nullopt;
    }
    const Part part = parse_part(given.text("--part"));
    if (whole.range.is_single()) {
        throw InputError("--part is for a range LO:HI: a single mass ratio has no parts");
    }
    return collisions::part_of(part, whole);
}

bool has_orbits(const CertifyRequest& request) { return row_of(request.claim.system.section).has_orbits; }

CertifyRequest certify_request(const Given& given, const std::optional<std::string>& line = std::nullopt) {
    CertifyRequest request{.claim = claim_of(given, line)};
    if (given.has("--witness") && !has_orbits(request)) {
        throw InputError("--witness prints orbits of the dumbbell, not of bodies: leave it out");
    }
    request.jobs = jobs_of(given);
    request.budget = budget_of(given);
    // Of a range nothing else prints it.
    request.describes = request.claim.range.is_single() || given.has("--json") || given.has("--witness");
    return request;
}

std::vector<ProvedPiece> prove_pieces(CertifyRequest request, Verbosity verbosity) {
    const bool looks_for_steps =
        !request.claim.range.is_single() && collisions::staircase_of(request.claim.system).step != nullptr;
    Progress progress(looks_for_steps ? "steps" : "boxes", verbosity,
                      looks_for_steps ? "looking for steps" : "proving");
    request.observer = &progress;
    return certify(request);
}

/// Orbits up to this long are traced in milliseconds, so that a start is said without being asked for.
constexpr long most_traced_unasked = 100;

collisions::ProofReport describe(const CertifyRequest& request, const std::vector<ProvedPiece>& pieces,
                                 double seconds, const Given& given) {
    const bool witness = given.has("--witness");
    const bool said_unasked = !given.has("--json") && !given.has("--quiet") &&
                              request.claim.range.is_single() && has_orbits(request);
    const Progress progress("", verbosity_of(given), "enclosing the orbits of witnesses");
    const Interrupted interrupted = deadline(std::nullopt);
    collisions::ProofReport report{.claim = request.claim,
                                   .jobs = request.jobs,
                                   .seconds = seconds,
                                   .undecided = undecided_share(pieces)};
    for (const ProvedPiece& p : pieces) {
        collisions::ReportRow row{&p.piece, p.margin, p.width, p.seconds, {}, {}};
        if (witness && p.piece.witness) {
            row.orbit = witness_orbit(*p.piece.witness, p.piece.q_lo, p.piece.bits);
        }
        const bool traced =
            witness ? !row.orbit.empty()
                    : said_unasked && p.piece.witness && p.piece.witness->total() <= most_traced_unasked;
        if (traced) {
            auto found = start_in_the_air(*p.piece.witness, p.piece.q_lo, interrupted);
            row.start = std::move(found.start);
            row.why_no_start = std::move(found.why_none);
        }
        report.rows.push_back(std::move(row));
    }
    return report;
}

std::vector<const collisions::Piece*> pieces_of(const std::vector<ProvedPiece>& proved) {
    std::vector<const collisions::Piece*> pieces;
    for (const ProvedPiece& p : proved) {
        pieces.push_back(&p.piece);
    }
    return pieces;
}

SealedText certificate_text(const CertifyRequest& request, const std::vector<ProvedPiece>& proved) {
    return render({.pieces = {}, .system = request.claim.system}, pieces_of(proved));
}

bool is_open(const std::vector<ProvedPiece>& pieces) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const ProvedPiece& p) { return p.piece.status() == collisions::Status::open; });
}

/// What is printed without --json and --quiet.
std::string text_of(const collisions::ProofReport& report, bool swapped, bool witness) {
    return fmt::format("{}{}{}{}", swapped ? masses_are_swapped : "", orbits_to_text(report),
                       witness ? "\n" : "", to_text(report));
}

/// What an earlier run has kept of a line of --list, if it is whole, decided, and about this; else nothing.
std::vector<ProvedPiece> kept_pieces(const CertifyRequest& request, const std::string& file) try {
    std::vector<ProvedPiece> pieces;
    if (std::error_code none; file.empty() || !std::filesystem::is_regular_file(file, none)) {
        return pieces;
    }
    collisions::Certificate kept = collisions::read_certificate(file);
    const bool is_same =
        !kept.sha256.empty() && kept.system == request.claim.system && kept.range() == request.claim.range;
    for (std::size_t i = 0; is_same && i < kept.pieces.size(); ++i) {
        pieces.emplace_back().piece = std::move(kept.pieces[i]);
        if (request.describes && has_orbits(request)) {
            describe_witness(pieces.back());
        }
    }
    return is_open(pieces) ? std::vector<ProvedPiece>() : std::move(pieces);
} catch (const InputError&) {  // damaged: it is made again
    return {};
}

/// What is said of a line of --list.
ListAnswer certify_line(const Given& given, const std::string& line, const std::string& out) {
    CertifyRequest request = certify_request(given, line);
    request.jobs = 1;
    request.describes = given.has("--json");
    const Stopwatch watch;
    auto pieces = kept_pieces(request, out);
    pieces = pieces.empty() ? certify(request) : std::move(pieces);
    const double seconds = watch.seconds();
    ListAnswer answer;
    for (const ProvedPiece& p : pieces) {
        answer.rows.push_back({p.piece.q_lo, p.piece.q_hi, p.piece.lower, p.piece.upper});
    }
    answer.is_decided = !is_open(pieces);
    const SealedText certificate = out.empty() ? SealedText{} : certificate_text(request, pieces);
    answer.certificate = certificate.text;
    answer.claim = answer.is_decided ? whole_demand(request.claim, pieces_of(pieces)) : "";
    if (given.has("--json")) {
        collisions::ProofReport report = describe(request, pieces, seconds, given);
        if (!out.empty()) {
            report.out = out;
            report.sha256 = certificate.sha256;
        }
        answer.json = to_json(report);
    }
    return answer;
}

int run_certify(const Given& given) {
    const bool body = is_about_body(given);
    if (given.has("--list")) {
        // What is wrong with an option is no line's fault. This number every section takes.
        const CertifyRequest request = certify_request(given, "1e12");
        std::string options = options_of(request.claim);
        for (const char* option : {"--rho", "--rod-mass"}) {
            options += given.has(option) ? fmt::format(" {} {}", option, given.text(option)) : "";
        }
        return answer_list(
            given,
            [&](const std::string& line, const std::string& out) { return certify_line(given, line, out); },
            fmt::format("dumbbell {} certify --list{}", DUMBBELL_VERSION, options));
    }
    if (!given.has("RATIO") && !body) {
        throw InputError("certify needs RATIO, --list FILE, or a body: --coin, or --rho and --inertia");
    }
    require_certificate_name(given);
    if (is_rectangle(given)) {
        return certify_rectangle(given);
    }
    CertifyRequest request = certify_request(given);  // before the output file is touched
    const auto part = part_of(given, request.claim);
    if (part) {
        request.claim.range = part->range;
    }
    const bool json = given.has("--json"), quiet = given.has("--quiet"), witness = given.has("--witness");
    const Output output(given.text("--out"), {}, json ? "--json" : nullptr);
    std::optional<collisions::PieceStore> store;
    const std::string partial = given.text("--out") + ".partial";
    if (output.file()) {
        if (!request.claim.range.is_single()) {  // it may take long: its finished pieces are kept
            request.store = &store.emplace(partial, request.claim);
        } else {
            collisions::PieceStore::require_none(partial);
        }
    }
    const Stopwatch watch;
    const auto pieces = prove_pieces(request, verbosity_of(given));
    const double seconds = watch.seconds();

    const bool open = is_open(pieces);
    const auto kept = store ? std::optional(KeptPieces{partial, store->size()}) : std::nullopt;
    if (open && stop_signal != 0) {
        return stopped(kept_when_stopped(request, pieces, kept));
    }
    collisions::ProofReport report = describe(request, pieces, seconds, given);
    report.part = part;
    if (output.is_wanted()) {
        write(certificate_text(request, pieces), output, report);
    }
    if (store && !open) {
        store->remove();
    }
    const bool swapped = !body && parse_ratio_argument(given.text("RATIO")).swapped;
    fmt::print(output.report(), "{}",
               json || quiet ? shown(report, given) : text_of(report, swapped, witness));
    if (open) {
        complain(advice(request, pieces, kept));
    }
    return open ? exit_not_certified : exit_done;
}

}  // namespace

constinit const Command certify_command{
    "certify", first_group, certify_description, certify_footer, certify_options, stoppable<run_certify>,
    {},        nullptr,     certify_topics};

}  // namespace dumbbell::cli
