#include "starts/answer/trace.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/claims/body.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/commands.hpp"
#include "cli/list/list.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/limits.hpp"
#include "number/ratio_argument.hpp"
#include "starts/answer/trace_report.hpp"
#include "starts/answer/writer.hpp"
#include "starts/cover/incoming.hpp"
#include "starts/cover/leaf.hpp"
#include "starts/cover/subdivide.hpp"
#include "starts/given/given_start.hpp"

namespace dumbbell::cli {

namespace {

constexpr const char* trace_description =
    R"(Follow one initial condition, or a box of them, through all its collisions.

RATIO is q = heavy mass / light mass (below 1 the masses are swapped). The dumbbell starts in the air, in a vertical
plane: the rod has length 1, the light mass is at height y + beta2 sin phi and the heavy one at y - beta1 sin phi
(beta2 = q/(1+q), beta1 = 1/(1+q)). y is the height of the centre of mass; phi is in radians (1/3), degrees (30deg) or a
multiple of pi (pi/2, 2pi/3, -0.3pi). Every quantity is exact, as written (3, -0.5, 1/3), or an interval LO:HI. A
multiple of pi is irrational: the proof holds for its rational bounds, which --json and the certificate give.

Every number is printed as value+-radius, or as its bounds (--json). The grazing sine is |n.v| / (|n| |v|)
before a collision, in the metric of the kinetic energy: the sine of the angle between flight and floor, 1 head-on, near
0 where the mass only just touches. What stays undecided has bounds: those of the enclosures, or the maximum over all
trajectories (theorem 1 of proofs/theorem.md) where that is less. Up to a ratio of 10^12 a certificate has the same
bounds.

Examples:
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2               one orbit
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2 --digits 50   the same with 50 digits
  dumbbell trace 10 --phi 30deg --phidot 1 --y 3 --ydot -1/2             phi = pi/6
  dumbbell trace 10 --phi pi/6:pi/3 --phidot 0 --y 3 --ydot -1           a box
  dumbbell trace 10 --phi 0:3 --phidot -1/2:1/2 --y 3/2 --ydot -1 --subdivide --out falling.dbc
  dumbbell trace 10 --phi 0:3 --phidot -1/2:1/2 --y 3/2 --ydot -1 --subdivide --shares
  dumbbell trace 10 --incoming --subdivide --shares                      how likely is each number of collisions?)";

constexpr const char* trace_footer =
    R"(Exit codes: 0 an outcome is certified; 1 internal error; 2 wrong usage or input, also of one line of a list; 3 not
decided at this precision, or at any (the start lies on or near a corner, a flat fall or a grazing contact); 130 or 143
stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array trace_topics{
    Topic{
        "bodies", "Follow a rigid body.",
        R"(A body is RATIO with --rod-mass, or --coin, or --rho with --inertia, which are numbers here. The light end is the one
at the distance d1 from the centre of mass, the heavy one that at d2; the rod length is d1 + d2. What is said holds in a
plane, and until a corner is met. There is no certificate of it.

Example:
  dumbbell trace --coin --phi 1/3 --phidot 1 --y 3 --ydot -1/2)"},
    Topic{
        "lists", lists_text,
        R"(Each ratio has the same start. With --subdivide, --out names a new folder, for the certificates. --list does not go
with --quiet.

Example:
  dumbbell trace --list ratios.txt --phi 1/3 --phidot 1 --y 3 --ydot -1/2    at each ratio of a file)"}};

constexpr Option quantity_option(std::string_view name, std::string_view text) {
    return Option{name, "A|LO:HI", text};
}

constexpr std::array start_options{
    ratio_option,
    list_option.excludes("RATIO,--quiet,--coin,--rho,--inertia,--rod-mass"),
    strict_option,
    quantity_option("--phi", "angle of the rod: radians, or like 30deg, pi/2, 0.3pi"),
    quantity_option("--phidot", "its velocity (radians)"),
    quantity_option("--y", "height of the centre of mass, rod lengths"),
    quantity_option("--ydot", "its velocity (downwards: negative)"),
    flag("--incoming",
         "with --subdivide, instead of these four and without --digits: all trajectories that come in from "
         "above, by the natural "
         "measure (L61 of proofs/lemmas.md)")
        .needs("--subdivide")
        .excludes("--phi,--phidot,--y,--ydot,--digits"),
    flag("--subdivide", "halve the box until every part has its exact number of collisions"),
    certificates_option
        .saying(
            "with --subdivide: write the certificate to FILE (FILE.gz: compressed); -: the standard output")
        .needs("--subdivide"),
    flag("--shares",
         "with --subdivide: how likely each number of collisions is, as proved bounds of its share")
        .needs("--subdivide"),
    Option{"--max-boxes", "N", "with --subdivide: at most this many parts", "50000"}
        .from(1, most_parts)
        .needs("--subdivide"),
    Option{"--budget", "TIME", "with --subdivide: stop halving after this time: 30s, 10m, 2h"}.needs(
        "--subdivide"),
    Option{"--digits", "N",
           "decimal digits to compute and show; with --subdivide also the precision for parts that double "
           "precision does not decide. Default: double precision"}
        .from(1, starts::most_trace_digits),
    jobs_option,
    json_option.excludes("--quiet"),
    flag("--quiet", "the outcome alone: a sentence, and with --subdivide the table of what was decided")};

constexpr auto trace_options = joined(start_options, body_options);

/// Bits of the bounds of an irrational angle: with --subdivide no more than a line of a certificate holds.
int bits_of_angle(const Given& given, int digits) {
    const int bits = starts::bits_of_bounds(digits);
    return given.has("--subdivide") ? std::min(bits, most_angle_bits) : bits;
}

/// What a verifier takes for too long is not worth any work.
void require_short_lines(const starts::Box& box) {
    constexpr std::array names{"--phi", "--phidot", "--y", "--ydot", "RATIO"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!collisions::fits_a_line({box.lo[i], box.hi[i]})) {
            throw InputError(fmt::format(
                "{}: too long for a line of a certificate (--out): write a number of fewer digits",
                names[i]));
        }
    }
}

/// Throws InputError unless there is a start.
void require_start(const Given& given) {
    for (const char* name : {"--phi", "--phidot", "--y", "--ydot"}) {
        if (!given.has("--incoming") && !given.has(name)) {
            throw InputError(
                fmt::format("{} is required (or --incoming --subdivide, for all incoming "
                            "trajectories); see dumbbell trace --help",
                            name));
        }
    }
}

/// A massless dumbbell's ratio, or a body's Q and rho.
struct System {
    RatioArgument ratio;
    std::optional<Rational> rho;
};

System system_of(const Given& given) {
    if (!is_about_body(given)) {
        return {given_ratio(given), {}};
    }
    const collisions::Claim body = body_claim(given);
    if (given.has("--out")) {
        throw InputError("there are no certificates about starts of bodies: leave out --out");
    }
    if (!body.range.is_single()) {
        throw InputError("trace follows a single body: --inertia is a number here, not a range");
    }
    return {{body.range.lo, body.range.lo, false}, body.system.rho};
}

starts::GivenStart start_of(const Given& given, const System& system, int digits) {
    return starts::read_start({.phi = given.text("--phi"),
                               .phidot = given.text("--phidot"),
                               .y = given.text("--y"),
                               .ydot = given.text("--ydot")},
                              system.ratio.lo, system.ratio.hi, "--", bits_of_angle(given, digits),
                              system.rho);
}

starts::Box incoming_box_of(const System& system) {
    if (system.ratio.lo != system.ratio.hi) {
        throw InputError("--incoming takes a single mass ratio: the natural measure depends on it");
    }
    return starts::incoming_box(system.ratio.lo, system.rho);
}

/// But for its tree.
starts::Certificate certificate_of_starts(const starts::TraceReport& report) {
    return {.box = report.box, .bits = report.parts->bits, .tree = {}, .incoming = report.incoming};
}

/// No trajectory has more than the maximum, whatever was found of these.
void bound_by_maximum(starts::TraceReport& report, const std::optional<long>& maximum) {
    report.maximum = maximum;
    const auto bound = [&](std::optional<long>& most) { most = most ? most : maximum; };
    bound(report.trace.most);
    if (report.parts) {
        bound(report.parts->most);
    }
}

/// But for what is found.
starts::TraceReport report_at(const Given& given, const System& system) {
    const int digits = given.has("--digits") ? static_cast<int>(given.number("--digits")) : 0;
    const bool incoming = given.has("--incoming");
    starts::GivenStart start =
        incoming ? starts::GivenStart{incoming_box_of(system), {}} : start_of(given, system, digits);
    if (given.has("--out")) {
        require_short_lines(start.box);
    }
    return {.box = std::move(start.box),
            .digits = digits,
            .meaning = std::move(start.meaning),
            .incoming = incoming,
            .shares = given.has("--shares")};
}

void halve(starts::TraceReport& report, const Given& given, int jobs, Verbosity verbosity,
           const Interrupted& interrupted) {
    Progress progress("boxes", verbosity, "halving the box");
    report.parts =
        subdivide(report.box,
                  starts::SubdivideOptions{.max_boxes = static_cast<std::size_t>(given.number("--max-boxes")),
                                           .jobs = jobs,
                                           .incoming = report.incoming,
                                           .bits = std::min(report.trace.bits, most_file_bits),
                                           .interrupted = interrupted,
                                           .observer = &progress});
    if (report.incoming) {
        report.trace.least = report.parts->least;
        report.trace.most = report.parts->most;
    }
}

/// Whether a signal has ended the work before everything was decided.
bool is_cut(const starts::TraceReport& report) {
    return stop_signal != 0 && (report.parts ? report.parts->undecided.share > 0 : !report.trace.exact());
}

void follow(starts::TraceReport& report, const Given& given, int jobs, Verbosity verbosity) {
    const Interrupted interrupted = deadline(budget_of(given));
    const Stopwatch watch;
    if (!report.incoming) {
        Progress progress("collisions", verbosity, "following the orbit");
        report.trace = trace(report.box, report.digits, progress, deadline(std::nullopt));
    }
    if (given.has("--subdivide")) {
        halve(report, given, jobs, verbosity, interrupted);
    }
    if (!is_cut(report) && (!report.trace.exact() || report.parts)) {
        bound_by_maximum(report, starts::most_of_all(report.box));
    }
    report.seconds = watch.seconds();
}

bool is_certified(const starts::TraceReport& report) {
    return report.trace.exact() || (!report.is_single() && !event_of(report));
}

SealedText text_of_certificate(const starts::TraceReport& report) {
    SealedText whole;
    whole.sha256 = render(certificate_of_starts(report), report.parts->tree,
                          [&](std::string_view part) { whole.text += part; });
    return whole;
}

/// What is said of a line of --list.
ListAnswer trace_line(const Given& given, const RatioArgument& ratio, const std::string& out) {
    starts::TraceReport report = report_at(given, {ratio, {}});
    follow(report, given, 1, Verbosity::quiet);
    ListAnswer answer{.rows = {{ratio.lo, ratio.hi, report.trace.least, report.trace.most}},
                      .is_decided = is_certified(report)};
    if (!out.empty()) {
        SealedText certificate = text_of_certificate(report);
        answer.certificate = std::move(certificate.text);
        report.out = out;
        report.sha256 = std::move(certificate.sha256);
    }
    answer.json = given.has("--json") ? to_json(report) : Json();
    return answer;
}

int run_trace(const Given& given) {
    require_start(given);
    if (given.has("--list") && !is_about_body(given)) {
        return answer_list(given, [&](const std::string& ratio, const std::string& out) {
            return trace_line(given, parse_ratio_argument(ratio), out);
        });
    }
    const System system = system_of(given);
    starts::TraceReport report = report_at(given, system);
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    follow(report, given, jobs_of(given), verbosity_of(given));
    if (is_cut(report)) {
        return stopped(
            report.parts
                ? "nothing is kept; with --budget TIME what is decided in time is printed, and written"
                : fmt::format("nothing is kept of the {} collisions that were found", report.trace.least));
    }
    if (output.is_wanted()) {
        output.commit([&](const Sink& sink) {
            report.sha256 = render(certificate_of_starts(report), report.parts->tree, sink);
        });
        report.out = output.file();
    }
    const bool explains = system.ratio.swapped && !given.has("--json") && !given.has("--quiet");
    fmt::print(output.report(), "{}{}", explains ? masses_are_swapped : "", shown(report, given));
    return is_certified(report) ? exit_done : exit_not_certified;
}

}  // namespace

constinit const Command trace_command{"trace",      more_group,    trace_description,
                                      trace_footer, trace_options, stoppable<run_trace>,
                                      {},           nullptr,       trace_topics};

}  // namespace dumbbell::cli
