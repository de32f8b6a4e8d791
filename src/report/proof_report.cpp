#include "report/proof_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "certificate/names.hpp"
#include "model/paper_bound.hpp"

namespace dumbbell {
namespace {

std::string_view name(Status status) {
    switch (status) {
        case Status::exact:
            return "exact";
        case Status::gap:
            return "gap";
        default:
            return "open";
    }
}

std::string range_text(const Rational& lo, const Rational& hi, int digits) {
    return lo == hi ? to_decimal(lo, digits) : to_decimal(lo, digits) + " : " + to_decimal(hi, digits);
}

std::string value_text(const Piece& piece) {
    switch (piece.status()) {
        case Status::exact:
            return fmt::format("{}", *piece.upper);
        case Status::gap:
            return fmt::format("{} or {}", piece.lower, *piece.upper);
        default:
            return piece.lower > 0 ? fmt::format(">= {}", piece.lower) : "open";
    }
}

/// The paper's bound grows with q: one number, or those at both ends; none for ratios that it is not computed
/// for.
std::string paper_text(const Piece& piece) {
    if (piece.q_hi > paper_bound_limit()) {
        return "-";
    }
    const long lo = paper_bound(piece.q_lo);
    const long hi = paper_bound(piece.q_hi);
    return lo == hi ? fmt::format("{}", lo) : fmt::format("{}-{}", lo, hi);
}

struct Counts {
    long exact = 0, gaps = 0, open = 0;
};

Counts count_statuses(const ProofReport& report) {
    Counts counts;
    for (const ReportRow& row : report.rows) {
        ++(row.piece->status() == Status::exact ? counts.exact
           : row.piece->status() == Status::gap ? counts.gaps
                                                : counts.open);
    }
    return counts;
}

std::string single_sentence(const ProofReport& report) {
    const Piece& piece = *report.rows.front().piece;
    const std::string q = to_decimal(report.q_lo, 17);
    if (piece.status() != Status::exact) {
        return fmt::format(
            "Not decided: at mass ratio {} only this is proved: some trajectory hits the floor at least {} "
            "times.\n",
            q, piece.lower);
    }
    return fmt::format(
        "Proved: at mass ratio {} no trajectory hits the floor more than {} times, and some trajectory hits "
        "it {} times.\n",
        q, *piece.upper, *piece.upper);
}

std::string range_sentence(const ProofReport& report) {
    const Counts counts = count_statuses(report);
    std::string text = fmt::format(
        "Proved: in each of the {} pieces with one value N, and for every mass ratio in it, no trajectory "
        "hits the floor more than N times\n"
        "and some trajectory hits it N times. ",
        counts.exact);
    if (counts.gaps > 0) {
        text += fmt::format(
            "In the {} gaps around the critical ratios the maximum is one of the two values. ", counts.gaps);
    }
    if (counts.open > 0) {
        text += fmt::format("{} pieces are open. ", counts.open);
    }
    text += fmt::format("Decided: {:.9f} of the range.\n", report.decided_fraction);
    return text;
}

/// The exact value of a number as it is printed, e.g. -1.5e-05.
Rational as_printed(std::string_view text) {
    const bool negative = text.starts_with('-');
    const Rational magnitude = parse_rational(text.substr(negative ? 1 : 0));
    return negative ? -magnitude : magnitude;
}

/// A short decimal and a radius that covers both ends from that decimal, so that the text as printed
/// encloses.
std::string enclosure_text(const Interval& x) {
    const std::string centre = fmt::format("{:.12g}", approximate(x));
    const Rational c = as_printed(centre);
    const double radius = std::abs(enclose<Interval>(std::max(exact(x.hi()) - c, c - exact(x.lo()))).hi());
    return fmt::format("{}+-{:.1e}", centre, radius * 1.06);  // two digits lose at most 1 part in 20
}

nlohmann::ordered_json pair(const Interval& x) { return {x.lo(), x.hi()}; }

nlohmann::ordered_json orbit_json(const ReportRow& row) {
    nlohmann::ordered_json collisions = nlohmann::ordered_json::array();
    for (const auto& c : row.orbit) {
        collisions.push_back({{"mass", c.heavy ? "heavy" : "light"},
                              {"time", pair(c.time)},
                              {"phi", pair(c.phi)},
                              {"y", pair(c.y)},
                              {"ydot_before", pair(c.ydot_before)},
                              {"ydot_after", pair(c.ydot_after)},
                              {"phidot_before", pair(c.phidot_before)},
                              {"phidot_after", pair(c.phidot_after)},
                              {"grazing_sine", pair(c.grazing_sine)}});
    }
    return {{"ratio", to_fraction(row.piece->q_lo)}, {"collisions", std::move(collisions)}};
}

}  // namespace

std::string to_text(const ProofReport& report) {
    struct Line {
        std::string ratio, value, paper, boxes, time;
    };
    std::vector<Line> lines{{"mass ratio", "N", "paper", "boxes", "time"}};
    for (const ReportRow& row : report.rows) {
        const Piece& piece = *row.piece;
        lines.push_back({range_text(piece.q_lo, piece.q_hi, 13), value_text(piece), paper_text(piece),
                         fmt::format("{}", piece.cover.leaves()), fmt::format("{:.3f} s", row.seconds)});
    }
    std::array<std::size_t, 5> widths{};
    for (const Line& line : lines) {
        widths = {std::max(widths[0], line.ratio.size()), std::max(widths[1], line.value.size()),
                  std::max(widths[2], line.paper.size()), std::max(widths[3], line.boxes.size()),
                  std::max(widths[4], line.time.size())};
    }
    std::string text;
    for (const Line& line : lines) {
        fmt::format_to(std::back_inserter(text), "{:<{}}  {:>{}}  {:>{}}  {:>{}}  {:>{}}\n", line.ratio,
                       widths[0], line.value, widths[1], line.paper, widths[2], line.boxes, widths[3],
                       line.time, widths[4]);
    }
    fmt::format_to(std::back_inserter(text), "{} in {:.2f} s with {} threads\n\n",
                   report.rows.size() == 1 ? "1 piece" : fmt::format("{} pieces", report.rows.size()),
                   report.seconds, report.jobs);
    text += report.q_lo == report.q_hi ? single_sentence(report) : range_sentence(report);
    if (report.out) {
        fmt::format_to(std::back_inserter(text),
                       "Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {}\n", *report.out,
                       *report.sha256, *report.out);
    }
    return text;
}

nlohmann::ordered_json to_json(const ProofReport& report) {
    nlohmann::ordered_json pieces = nlohmann::ordered_json::array();
    for (const ReportRow& row : report.rows) {
        const Piece& piece = *row.piece;
        nlohmann::ordered_json entry{{"lo", to_fraction(piece.q_lo)},
                                     {"hi", to_fraction(piece.q_hi)},
                                     {"upper", nullptr},
                                     {"lower", piece.lower},
                                     {"status", name(piece.status())},
                                     {"paper_bound", nullptr},
                                     {"leaves", piece.cover.leaves()},
                                     {"bits", piece.bits},
                                     {"margin", row.margin},
                                     {"width", row.width}};
        if (piece.upper) {
            entry["upper"] = *piece.upper;
        }
        if (piece.q_hi <= paper_bound_limit()) {
            entry["paper_bound"] = paper_bound(piece.q_hi);
        }
        if (!row.orbit.empty()) {
            entry["witness"] = orbit_json(row);
        }
        pieces.push_back(std::move(entry));
    }
    nlohmann::ordered_json json{
        {"schema", "dumbbell-certify-1"},
        {"scene", name(report.scene)},
        {"section", name(report.section)},
        {"lemmas", lemma_set(report.section)},
        {"ratio", {{"lo", to_fraction(report.q_lo)}, {"hi", to_fraction(report.q_hi)}}},
        {"gap", to_fraction(report.gap)},
        {"jobs", report.jobs},
        {"pieces", std::move(pieces)},
        {"decided_fraction", report.decided_fraction},
        {"seconds", report.seconds},
        {"out", nullptr},
        {"sha256", nullptr}};
    if (report.out) {
        json["out"] = *report.out;
        json["sha256"] = *report.sha256;
    }
    return json;
}

std::string orbits_to_text(const ProofReport& report) {
    std::string text;
    for (const ReportRow& row : report.rows) {
        if (row.orbit.empty()) {
            continue;
        }
        fmt::format_to(
            std::back_inserter(text),
            "Witness at mass ratio {}: {} collisions. Rod length 1; phi in radians; y: height of the centre "
            "of mass;\n"
            "unit of time: phidot^2 + q (ydot / beta2)^2 = 1. Each number is enclosed: value+-radius.\n",
            to_decimal(row.piece->q_lo, 17), row.orbit.size());
        fmt::format_to(std::back_inserter(text),
                       "{:>4} {:5} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24}\n", "#", "mass", "time",
                       "phi", "y", "ydot before", "ydot after", "phidot before", "phidot after");
        long number = 0;
        for (const auto& c : row.orbit) {
            fmt::format_to(std::back_inserter(text),
                           "{:>4} {:5} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24} {:>24}\n", ++number,
                           c.heavy ? "heavy" : "light", enclosure_text(c.time), enclosure_text(c.phi),
                           enclosure_text(c.y), enclosure_text(c.ydot_before), enclosure_text(c.ydot_after),
                           enclosure_text(c.phidot_before), enclosure_text(c.phidot_after));
        }
        fmt::format_to(
            std::back_inserter(text),
            "Smallest margin (angle between flight and floor, in the kinetic metric): {:.6g} rad\n\n",
            row.margin);
    }
    return text;
}

}  // namespace dumbbell
