#include "cli/commands/trace.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "collisions/critical.hpp"
#include "number/ratio_argument.hpp"
#include "starts/argument.hpp"
#include "starts/initial_state.hpp"
#include "starts/subdivide.hpp"
#include "starts/trace.hpp"
#include "starts/trace_report.hpp"
#include "starts/writer.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

struct Options {
    std::string ratio, phi, phidot, y, ydot;
    std::string out;
    std::string budget;
    std::size_t max_boxes = SubdivideOptions{}.max_boxes;
    int digits = 0;
    int jobs = all_cores();
    bool subdivide = false;
    bool json = false;
    bool csv = false;
    bool quiet = false;
};

constexpr int most_subdivide_bits = 4096;  ///< of a certificate

constexpr const char* description =
    R"(Follow one initial condition, or a box of them, through all its collisions.

RATIO is q = heavy mass / light mass (below 1 the masses are swapped). The dumbbell starts in the air: the
rod has length 1, the light mass is at height y + beta2 sin phi and the heavy one at y - beta1 sin phi
(beta2 = q/(1+q), beta1 = 1/(1+q)), y is the height of the centre of mass, phi in radians. Every quantity is
exact, as written (3, -0.5, 1/3), or an interval LO:HI.

Every number is printed as value+-radius, or as its bounds (--csv, --json). The grazing sine is |n.v| / (|n| |v|)
before a collision, in the metric of the kinetic energy: the sine of the angle between flight and floor, 1 head-on, near
0 where the mass only just touches. What is left undecided has bounds: those that the enclosures give, or the maximum over
all trajectories (theorem 2 of proofs/theorem.md, up to mass ratio 10^6) where that is less.

Examples:
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2               one orbit
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2 --digits 50   the same with 50 digits
  dumbbell trace 10 --phi 0.3:0.31 --phidot 0 --y 3 --ydot -1            a box
  dumbbell trace 10 --phi 0:3 --phidot -1/2:1/2 --y 3/2 --ydot -1 --subdivide --out falling.dbc)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 an outcome is certified; 1 internal error; 2 wrong usage or input; 3 not decided at this precision; with
--subdivide 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

InitialBox box_of(const Options& options, const RatioArgument& ratio) {
    InitialBox box;
    const auto set = [&](InitialAxis axis, Rational lo, Rational hi) {
        box.lo[static_cast<std::size_t>(axis)] = std::move(lo);
        box.hi[static_cast<std::size_t>(axis)] = std::move(hi);
    };
    const auto quantity = [&](InitialAxis axis, const char* name, const std::string& text) {
        auto [lo, hi] = parse_quantity(name, text);
        set(axis, std::move(lo), std::move(hi));
    };
    quantity(InitialAxis::phi, "--phi", options.phi);
    quantity(InitialAxis::phidot, "--phidot", options.phidot);
    quantity(InitialAxis::y, "--y", options.y);
    quantity(InitialAxis::ydot, "--ydot", options.ydot);
    set(InitialAxis::ratio, ratio.lo, ratio.hi);
    require_in_play(box);
    return box;
}

void write_certificate(TraceReport& report, const Output& output) {
    SealedText text = render(InitialCertificate{.program = "dumbbell",
                                                .version = DUMBBELL_VERSION,
                                                .box = report.box,
                                                .bits = report.parts->bits,
                                                .tree = report.parts->tree});
    output.commit(text.text);
    report.out = output.file();
    report.sha256 = std::move(text.sha256);
}

void print(std::FILE* out, const Options& options, const TraceReport& report, bool swapped) {
    if (options.json) {
        fmt::print(out, "{}", json_text(to_json(report)));
    } else if (options.quiet) {
        fmt::print(out, "{}", verdict(report));
    } else if (options.csv) {
        fmt::print(out, "{}", to_csv(report));
        remark(outcome_sentence(report));
        if (const std::string theorem = theorem_sentence(report); !theorem.empty()) {
            remark(theorem);
        }
    } else {
        fmt::print(out, "{}{}", swapped ? "Ratios below 1: the masses are swapped, q -> 1/q.\n" : "",
                   to_text(report));
    }
}

int run(const Options& options) {
    const RatioArgument ratio = parse_ratio_argument(options.ratio);
    TraceReport report{.box = box_of(options, ratio),
                       .trace = {},
                       .digits = options.digits,
                       .parts = {},
                       .seconds = 0,
                       .out = {},
                       .sha256 = {}};
    const Output output(options.out, {}, options.json ? "--json" : options.csv ? "--csv" : nullptr);
    const auto budget = options.budget.empty() ? std::nullopt : std::optional(parse_duration(options.budget));
    SubdivideOptions limits{
        .max_boxes = options.max_boxes, .jobs = options.jobs, .interrupted = deadline(budget)};
    const Loudness loudness = options.quiet ? Loudness::quiet : Loudness::normal;
    const auto start = std::chrono::steady_clock::now();
    {
        const Progress progress("", loudness, "following the orbit");
        report.trace = trace(report.box, options.digits);
    }
    const auto finish = [&] {
        if (!report.trace.exact() || (report.parts && report.parts->undecided.share > 0)) {
            report.maximum = bound_by_theorem(ratio.hi);
        }
        report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (output.is_wanted()) {
            write_certificate(report, output);
        }
        print(output.report(), options, report, ratio.swapped);
        const bool certified = !report.box.is_point() || report.trace.exact();
        return certified ? exit_done : exit_not_certified;
    };
    if (!options.subdivide) {
        return finish();
    }
    return stoppable([&] {
        limits.bits = std::min(report.trace.bits, most_subdivide_bits);
        {
            Progress progress("boxes", loudness, "halving the box");
            limits.judged = [&](std::size_t boxes) { progress.advance(boxes); };
            report.parts = subdivide(report.box, limits);
        }
        if (stop_signal != 0 && report.parts->undecided.share > 0) {
            complain(stopped_by() +
                     ": nothing is kept; with --budget TIME what is decided in time is printed, and written");
            return exit_stopped;
        }
        return finish();
    });
}

}  // namespace

void add_trace_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("trace", description);
    command->footer(footer);
    command->add_option("RATIO", options->ratio, "mass ratio, or closed range LO:HI")->required();
    command->add_option("--phi", options->phi, "angle of the rod, radians")->required()->type_name("A|LO:HI");
    command->add_option("--phidot", options->phidot, "its velocity")->required()->type_name("A|LO:HI");
    command->add_option("--y", options->y, "height of the centre of mass, rod lengths")
        ->required()
        ->type_name("A|LO:HI");
    command->add_option("--ydot", options->ydot, "its velocity (downwards: negative)")
        ->required()
        ->type_name("A|LO:HI");
    CLI::Option* subdivide =
        command->add_flag("--subdivide", options->subdivide,
                          "halve the box until every part has its exact number of collisions");
    add_out_option(*command, options->out, {Content::certificate},
                   "with --subdivide: write the certificate to FILE (FILE.gz: compressed)")
        ->needs(subdivide);
    command->add_option("--max-boxes", options->max_boxes, "with --subdivide: at most this many parts")
        ->needs(subdivide)
        ->check(CLI::Range(1UL, 10'000'000UL))
        ->capture_default_str();
    command
        ->add_option("--budget", options->budget,
                     "with --subdivide: stop halving after this time: 30s, 10m, 2h")
        ->needs(subdivide)
        ->type_name("TIME");
    command
        ->add_option("--digits", options->digits,
                     "decimal digits to compute and show; with --subdivide also the precision for parts that "
                     "double precision does not decide. Default: double precision")
        ->check(CLI::Range(1, most_trace_digits));
    add_jobs_option(*command, options->jobs);
    CLI::Option* json = command->add_flag("--json", options->json, "one JSON object on stdout");
    CLI::Option* csv =
        command
            ->add_flag("--csv", options->csv,
                       "a table with the bounds of every number on stdout, the outcome on stderr")
            ->excludes(json);
    command->add_flag("--quiet", options->quiet, "the outcome alone, in a sentence")
        ->excludes(json)
        ->excludes(csv);
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace dumbbell
