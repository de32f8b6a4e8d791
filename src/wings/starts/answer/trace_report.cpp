#include "starts/answer/trace_report.hpp"

#include <fmt/core.h>

#include <array>

#include "base/printable.hpp"
#include "number/decimal.hpp"
#include "starts/answer/event_text.hpp"
#include "starts/answer/mean.hpp"
#include "starts/answer/shares.hpp"
#include "starts/answer/writer.hpp"
#include "words/printed.hpp"
#include "words/text_table.hpp"

namespace dumbbell::starts {

using flight::Collision;

namespace {

struct Quantity {
    const char* key;
    const char* title;
    TracedValue Collision<TracedValue>::*value;
};

constexpr std::array<Quantity, 8> quantities{
    {{"time", "time", &Collision<TracedValue>::time},
     {"phi", "phi", &Collision<TracedValue>::phi},
     {"y", "y", &Collision<TracedValue>::y},
     {"ydot_before", "ydot before", &Collision<TracedValue>::ydot_before},
     {"ydot_after", "ydot after", &Collision<TracedValue>::ydot_after},
     {"phidot_before", "phidot before", &Collision<TracedValue>::phidot_before},
     {"phidot_after", "phidot after", &Collision<TracedValue>::phidot_after},
     {"grazing_sine", "grazing sine", &Collision<TracedValue>::grazing_sine}}};

constexpr std::array<const char*, axis_count> json_names{"phi", "phidot", "y", "ydot", "ratio"};
constexpr std::array<const char*, axis_count> json_names_of_incoming{"phi_over_pi", "s", nullptr, nullptr,
                                                                     "ratio"};

const char* mass_name(const Collision<TracedValue>& c) { return c.heavy ? "heavy" : "light"; }

const char* outcome_word(const TraceReport& report) {
    return report.trace.exact() ? "exact" : report.is_single() ? "undecided" : "between";
}

std::string bounds_text(long least, const std::optional<long>& most) {
    return most == least ? plural(least, "collision")
           : most        ? fmt::format("between {} and {} collisions", least, *most)
                         : fmt::format("at least {}", plural(least, "collision"));
}

/// Whether a bound that is said is that of all trajectories.
bool rests_on_theorem(const TraceReport& report) {
    const auto is_general = [&](long least, const std::optional<long>& most) {
        return most && most != least && most == report.maximum;
    };
    return is_general(report.trace.least, report.trace.most) ||
           (report.parts && is_general(report.parts->least, report.parts->most));
}

/// What bounds all motions of a body.
const char* body_lemma(const Box& box) { return *box.rho == 1 ? "L72" : "L84"; }

/// What a bound rests on that the enclosures do not give; else nothing.
std::string theorem_sentence(const TraceReport& report) {
    if (!rests_on_theorem(report)) {
        return "";
    }
    return report.box.rho
               ? fmt::format("No motion of the body in a plane has more than {} ({} of proofs/body.md).",
                             plural(*report.maximum, "collision"), body_lemma(report.box))
               : fmt::format("No trajectory at {} {} has more than {} (theorem 1 of proofs/theorem.md).",
                             report.box.lo[4] == report.box.hi[4] ? "mass ratio" : "mass ratios up to",
                             exact_text(report.box.hi[4]), plural(*report.maximum, "collision"));
}

/// What to do about an orbit that is not decided.
std::string advice(const TraceReport& report) {
    constexpr int first_digits = 40;
    if (report.digits == 0) {
        return fmt::format("try --digits {}", first_digits);
    }
    const std::string more =
        2 * report.digits <= most_trace_digits
            ? fmt::format("try --digits {}; if more digits do not help, ", 2 * report.digits)
            : "";
    return more +
           "move the initial condition a little: both masses touch almost at once there, or one only grazes "
           "the floor";
}

std::string collisions_table(const TraceReport& report) {
    std::vector<TableLine> lines{{"   #", "mass"}};
    for (const Quantity& q : quantities) {
        lines[0].emplace_back(q.title);
    }
    for (const auto& c : report.trace.collisions) {
        TableLine line{std::to_string(lines.size()), mass_name(c)};
        for (const Quantity& q : quantities) {
            line.push_back((c.*q.value).text);
        }
        lines.push_back(std::move(line));
    }
    return aligned(lines, 1);
}

/// What the box has to do with a start that is given by an irrational angle.
std::string meaning_text(const TraceReport& report) {
    const std::string& phi = report.meaning.rounded_phi;
    return phi.empty()
               ? ""
               : fmt::format(
                     "phi: {}, irrational and rounded outward; what is said is proved for every phi in the "
                     "interval that --json gives\n",
                     phi);
}

constexpr int share_digits = 12;

/// Cut off: what is said to be certified is.
std::string share_at_least(const Rational& share) {
    return share == 0 ? "0" : to_text(without_zeros(cut_down(share, share_digits)));
}

std::string decided_text(const Subdivision& parts) {
    std::string text = fmt::format("{:>10}  {:>22}  {:>9}\n", "collisions", "share of the box", "boxes");
    for (const auto& part : parts.exact) {
        text += fmt::format("{:>10}  {:>22}  {:>9}\n", part.first, share_at_least(part.second.share),
                            part.second.boxes);
    }
    text += fmt::format("{:>10}  {:>22}  {:>9}\n", "undecided",
                        to_text(without_zeros(cut_up(parts.undecided.share, share_digits))),
                        parts.undecided.boxes);
    return text + kinds_text(parts);
}

/// Whether theorem 6 or L85 is about what is asked.
bool has_mean(const TraceReport& report) { return report.incoming && report.shares; }

std::string subdivision_text(const TraceReport& report) {
    const Subdivision& parts = *report.parts;
    const char* whole = report.incoming ? "trajectories" : "box";
    std::string text = report.shares
                           ? fmt::format("{:>12}  share of the {} with exactly that many: proved bounds\n{}",
                                         "collisions", whole, share_lines(share_bounds(report.parts->tree)))
                           : decided_text(parts);
    if (has_mean(report)) {
        text += mean_text(report.box, parts.tree);
    }
    text += fmt::format("Certified: {} of the {} with its exact count; every {} has {}.\n",
                        share_at_least(Rational(1) - parts.undecided.share), whole,
                        report.incoming ? "one of them" : "initial condition in it",
                        bounds_text(parts.least, parts.most));
    return text;
}

Json enclosure_json(const TracedValue& value, bool decimals) {
    return decimals ? Json::array({value.lo, value.hi}) : ends_json(value.outward);
}

Json collision_json(const Collision<TracedValue>& c, bool decimals) {
    Json json = Json::object({{"mass", mass_name(c)}});
    for (const Quantity& q : quantities) {
        json.add(q.key, enclosure_json(c.*q.value, decimals));
    }
    return json;
}

Json subdivision_json(const TraceReport& report) {
    const Subdivision& parts = *report.parts;
    Json exact = Json::array();
    for (const auto& part : parts.exact) {
        exact.add(Json::object({{"collisions", part.first},
                                {"share", to_fraction(part.second.share)},
                                {"boxes", part.second.boxes}}));
    }
    const Share& undecided = parts.undecided;
    Json json = Json::object({{"exact", exact},
                              {"undecided", Json::object({{"share", to_fraction(undecided.share)},
                                                          {"boxes", undecided.boxes},
                                                          {"near", kinds_json(parts)}})},
                              {"least", parts.least},
                              {"most", parts.most},
                              {"decided_fraction", decided_fraction(undecided.share)}});
    if (report.shares) {
        json.add("shares", share_json(share_bounds(report.parts->tree)));
    }
    if (has_mean(report)) {
        json.add("mean", mean_json(report.box, parts.tree));
    }
    return json;
}

}  // namespace

std::optional<ExactEvent> event_of(const TraceReport& report) {
    return report.incoming ? std::nullopt : exact_event(report.box, report.meaning.phi);
}

std::string outcome_sentence(const TraceReport& report) {
    const Trace& trace = report.trace;
    if (report.incoming) {
        return fmt::format(
            "all incoming trajectories, by their natural measure (L61 of proofs/lemmas.md): {}",
            bounds_text(trace.least, trace.most));
    }
    if (trace.exact()) {
        return fmt::format("exactly {}{}", plural(trace.least, "collision"),
                           trace.least > static_cast<long>(trace.collisions.size())
                               ? fmt::format(" (enclosed: the first {})", trace.collisions.size())
                           : event_of(report)
                               ? " (in every turn a mass grazes the floor, which does not count)"
                               : "");
    }
    const std::string bounds = bounds_text(trace.least, trace.most);
    const auto next = trace.collisions.size() + 1;
    if (const auto event = event_of(report)) {
        return fmt::format(
            "cannot be decided at any precision: {}; {}; move the initial condition, for example --phi",
            bounds, corner_text(*event));
    }
    if (report.is_single()) {
        const std::string near = event_text(trace.obstacle.value_or(Obstacle::other));
        return fmt::format("cannot be decided at this precision: {}; undecided from collision {} on{}; {}",
                           bounds, next, near.empty() ? "" : " (on or near " + near + ")", advice(report));
    }
    return fmt::format("{}: the box splits at collision {}{}", bounds, next,
                       report.parts ? "" : " (smaller boxes: --subdivide)");
}

std::string verdict(const TraceReport& report) {
    const std::string theorem = theorem_sentence(report);
    return outcome_sentence(report) + '\n' + (report.parts ? '\n' + subdivision_text(report) : "") + theorem +
           (theorem.empty() ? "" : "\n");
}

std::string to_text(const TraceReport& report) {
    std::string text;
    if (!report.trace.collisions.empty()) {
        text += fmt::format(
            "{} {}; rod length 1, phi in radians, y: height of the centre of mass. Each number is "
            "enclosed: "
            "value+-radius.\nGrazing sine: 1 where a mass hits head-on, near 0 where it only just touches.\n",
            report.box.rho ? fmt::format("Body of rho {}, Q", exact_text(*report.box.rho)) : "Mass ratio",
            report.box.lo[4] == report.box.hi[4]
                ? exact_text(report.box.lo[4])
                : exact_text(report.box.lo[4]) + " : " + exact_text(report.box.hi[4]));
        text += collisions_table(report);
        if (const auto& widths = report.trace.widths; widths && !report.is_single()) {
            text += fmt::format("Widths after the last of them: {:.3g} with correlations, {} without\n",
                                widths->correlated,
                                widths->natural ? fmt::format("{:.3g}", *widths->natural)
                                                : std::string("plain intervals do not get as far"));
        }
    }
    text += meaning_text(report) + verdict(report);
    if (report.out) {
        constexpr int most_unasked = 2048;  // the verifier's --max-bits, unless it is told otherwise
        const Subdivision& parts = *report.parts;
        const std::string more = parts.bits > most_unasked ? fmt::format("--max-bits {} ", parts.bits) : "";
        text += fmt::format("Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {}{} {}\n",
                            one_line(*report.out), *report.sha256, more,
                            claim_options(report.incoming, report.box, parts.least, parts.most,
                                          Rational(1) - parts.undecided.share),
                            shell_file(*report.out));
    }
    return text;
}

Json to_json(const TraceReport& report) {
    const Trace& trace = report.trace;
    Json initial = Json::object();
    for (std::size_t i = 0; i < axis_count; ++i) {
        const char* name = report.incoming ? json_names_of_incoming[i] : json_names[i];
        if (name == nullptr) {
            continue;
        }
        Json axis =
            Json::object({{"lo", to_fraction(report.box.lo[i])}, {"hi", to_fraction(report.box.hi[i])}});
        if (i == 0 && !report.meaning.rounded_phi.empty()) {
            axis.add("given", report.meaning.rounded_phi);
        }
        initial.add(name, axis);
    }
    if (report.box.rho) {
        initial.add("rho", to_fraction(*report.box.rho));
    }
    Json collisions = Json::array();
    for (const auto& c : trace.collisions) {
        collisions.add(collision_json(c, report.digits > 0));
    }
    Json widths;
    if (trace.widths && !report.is_single()) {
        widths = Json::object({{"natural", trace.widths->natural}, {"correlated", trace.widths->correlated}});
    }
    const bool by_theorem = rests_on_theorem(report);
    Json object = Json::object(
        {{"schema", "dumbbell-trace-1"},
         {"initial", initial},
         {"outcome", outcome_word(report)},
         {"least", trace.least},
         {"most", trace.most},
         {"maximum", by_theorem ? report.maximum : std::nullopt},
         {"rests_on", !by_theorem      ? Json()
                      : report.box.rho ? Json(fmt::format("proofs/body.md, {}", body_lemma(report.box)))
                                       : Json("proofs/theorem.md, theorem 1")},
         {"splits_at", trace.exact() || report.incoming ? Json() : Json(trace.collisions.size() + 1)},
         {"bits", trace.bits},
         {"collisions", collisions},
         {"widths", widths},
         {"parts", report.parts ? subdivision_json(report) : Json()},
         {"seconds", report.seconds},
         {"out", report.out},
         {"sha256", report.sha256}});
    const auto event = event_of(report);
    if (event || (report.is_single() && trace.obstacle)) {
        object.add("event", event_json(event, trace.obstacle, trace.collisions.size()));
    }
    return object;
}

}  // namespace dumbbell::starts
